#pragma once

#include "player/layout/pack/contacts.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// The input of a packing: the shapes, their wished scales, the canvas.
struct PackingProblem {
    std::vector<Shape> shapes;
    std::vector<double> scales;  // wished canvas px per source px, relative: all are multiplied by one growth
    std::vector<double> limits;  // largest scale of each item: beyond it the picture is blurred, or does not
                                 // fit on the canvas
    std::vector<bool> pinned;    // the item keeps its place and its scale, which is scales[i] at every growth
    std::vector<Vec2> pinned_places;  // canvas px, centroids; valid for pinned items only
    Box field;                        // canvas px; I-Regions stay inside
    Box canvas;                       // canvas px; pictures are to fill it; empty: the field
    double clearance = 0;             // canvas px between I-Regions
    bool keeps_order = false;         // the items keep their reading order
    std::size_t bands = 0;            // the last shapes are no items: pinned, and in no order

    std::size_t size() const { return shapes.size(); }

    /// The number of shapes that are items.
    std::size_t items() const { return shapes.size() - bands; }

    /// The box that pictures are to fill, canvas px. It reaches to the canvas' edge, where I-Regions do not.
    const Box& whole() const { return canvas.is_empty() ? field : canvas; }

    /// The scale of an item at a growth: scales * growth, up to the limit.
    double scale(std::size_t item, double growth) const;

    /// The scale of an item as a function of the growth.
    GrowingScale growing_scale(std::size_t item) const;

    /// The box of places at which an item's region is inside the field. For a pinned item it has no limits.
    Box place_range(std::size_t item, double growth) const;
};

/// The places of all items: centroids in canvas px.
struct Arrangement {
    std::vector<Vec2> places;
    double growth = 1;
};

/// The lines of the items for reading, at a growth.
ReadingOrder reading_order(const PackingProblem& problem, double growth);

/// The point of a box nearest to a place.
Vec2 moved_into(Vec2 place, const Box& range);

/// True if all items are clear of each other, inside the field and, if required, in order. Sets the scales of
/// `contacts`.
bool is_free(const PackingProblem& problem, const Arrangement& arrangement, Contacts& contacts);

/// True if no two I-Regions share inner points, on the grid of exact areas. Pairs of pinned items are
/// skipped.
bool is_exactly_free(const PackingProblem& problem, const Arrangement& arrangement);

/// True if an item may be at a place while the others stay. @pre `contacts` has the scales of the arrangement
bool is_allowed_place(const PackingProblem& problem, const Contacts& contacts, const Arrangement& arrangement,
                      std::size_t item, Vec2 place);

/// True if all items are in order, except pairs of pinned ones.
bool is_in_order(const PackingProblem& problem, const std::vector<Vec2>& places, double growth);

/// The largest growth in [min, max] at which all items are free at their places; 0: there is none.
double max_free_growth(const PackingProblem& problem, const Arrangement& arrangement,
                       const Contacts& contacts, double min, double max);

/// The largest scale, up to `max`, at which an item is free at its place while the others stay; 0: there is
/// none. Ignores the order.
double max_free_scale(const PackingProblem& problem, const Arrangement& arrangement, const Contacts& contacts,
                      std::size_t item, double max);

/// The growth at which every item has reached its limit.
double final_growth(const PackingProblem& problem);

/// The arrangement's scales for Contacts::set_scales.
std::vector<double> scales_at(const PackingProblem& problem, double growth);

/// Area of all I-Regions, canvas px^2; bands are none.
double region_area(const PackingProblem& problem, double growth);

}  // namespace vitrine::player
