#pragma once

#include "player/layout/pack/contacts.hpp"
#include "player/layout/pack/reading_order.hpp"

#include <span>
#include <vector>

namespace vitrine::player {

/// What an arrangement must respect: the shapes, their scales, the canvas.
struct Ground {
    std::vector<Shape> shapes;
    std::vector<double> scales;  // wished canvas px per source px, relative: all are multiplied by one growth
    std::vector<double> limits;  // no item beyond this scale: blur, or it would not fit on the canvas
    std::vector<bool> pinned;    // keeps its place and its scale, which is scales[i] whatever the growth
    std::vector<Vec2> pinned_places;  // canvas px, centroids; of pinned items only
    Box field;                        // canvas px, where I-Regions may be
    double clearance = 0;             // canvas px between I-Regions
    bool reads = false;               // the items are read in their order

    std::size_t size() const { return shapes.size(); }

    /// The scale of an item at a growth: scales * growth, up to the limit.
    double scale(std::size_t item, double growth) const;

    /// The same as a function of the growth.
    Growing growing(std::size_t item) const;

    /// Where an item's centroid may be for the region to lie in the field. A pinned item: anywhere.
    Box range(std::size_t item, double growth) const;
};

/// Where all items stand. Places are centroids in canvas px.
struct Arrangement {
    std::vector<Vec2> places;
    double growth = 1;
};

/// What the order of items demands at a growth.
ReadingOrder reading_order(const Ground& ground, double growth);

/// Moves a place into a box.
Vec2 held(Vec2 place, const Box& range);

/// Whether all items keep clear of each other and inside the field, and the order where it counts. Sets the
/// scales of `contacts`.
bool is_free(const Ground& ground, const Arrangement& arrangement, Contacts& contacts);

/// Whether no two I-Regions share inner points, on the grid of exact areas; pinned items
/// among themselves excepted.
bool is_exactly_free(const Ground& ground, const Arrangement& arrangement);

/// Whether an item may stand at a place, if the others stay. @pre the scales of `contacts` are those of the
/// arrangement
bool may_stand(const Ground& ground, const Contacts& contacts, const Arrangement& arrangement,
               std::size_t item, Vec2 place);

/// Whether the order holds wherever it counts.
bool is_in_order(const Ground& ground, const std::vector<Vec2>& places, double growth);

/// The most growth, within bounds, at which all items are free where they stand; 0 where none is.
double greatest_growth(const Ground& ground, const Arrangement& arrangement, const Contacts& contacts,
                       double least, double most);

/// The most scale, up to `most`, at which an item is free where it stands if the others stay; 0 where none
/// is. The order is not looked at.
double greatest_scale(const Ground& ground, const Arrangement& arrangement, const Contacts& contacts,
                      std::size_t item, double most);

/// The growth at which every item is at its limit.
double final_growth(const Ground& ground);

/// The arrangement's scales for Contacts::set_scales.
std::vector<double> scales_at(const Ground& ground, double growth);

/// Area of all I-Regions, canvas px^2.
double region_area(const Ground& ground, double growth);

}  // namespace vitrine::player
