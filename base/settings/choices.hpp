#pragma once

namespace vitrine {

// Settings with a few words as values, each as an enum. setting_keys.cpp has the words.

/// The shape of the region around the important part of a shot (analyzer.region).
enum class RegionMode {
    min_area,  // the smallest convex region that holds enough of the saliency
    hull,      // the paper's: convex hull of the most salient pixels that together have enough of it
};

/// The way in which the important part of a picture is found (analyzer.saliency).
enum class SaliencyMethod {
    network,  // by a neural network too; of photos once a plain region is known
    student,  // by a small network that has learnt from it, at once
    plain,    // by contrast, motion, place and faces only
};

/// The energy that a layout minimises (layout.energy).
enum class EnergyMode {
    screen,  // share of the screen not covered by I-Regions, with escape from local minima
    paper,   // eq. 3.4 by descent alone, for reproducing the paper
};

/// The shots that stand beside each other on a new wall.
enum class NeighbourChoice {
    any,
    alike,  // shots of one moment or of like colours, where packing allows
};

/// The allowed places of items (layout.order).
enum class LayoutOrder {
    free,     // each item where it fits best
    reading,  // in lines, each item after the one before, from the top and from left to right
};

/// The division of the space between I-Regions (layout.cells).
enum class CellMethod {
    taut,     // the exact diagram, whose borders are then pulled taut between the regions
    exact,    // Voronoi diagram of the regions' outlines
    sampled,  // the paper's: Voronoi diagram of points along the outlines
};

/// The look of the cells' edges (layout.look).
enum class WallLook {
    seamless,  // cut edge to edge
    tiles,     // a thin gutter and round corners
    soft,      // neighbours fade into each other
};

/// The kind of wall (layout.mode).
enum class WallMode {
    fit,  // all slots on one screen
    pan,  // a ribbon as high as the screen, which passes by
};

/// The role of folders in a layout (layout.folders).
enum class FolderMode {
    flat,    // ignored
    nested,  // each folder is one place on the wall, and opens
};

/// The captions on the wall.
enum class CaptionChoice {
    none,
    written,  // by the operator, in a file beside the medium
    names,    // those, and else the names of files
};

/// The order in which shots come to the wall (show.order). The shots of one film always come in time order.
enum class ShotOrder {
    shuffle,
    name,    // by path
    newest,  // by modification time, the newest first
    taken,   // by the time at which the camera took them, the earliest first
};

/// The place of a film with several shots on the wall (show.film).
enum class FilmShow {
    automatic,     // in sequence if the film is alone on the wall, else side by side
    side_by_side,  // its shots may be beside each other; each shot of the catalogue is shown once before any
                   // repeats
    sequence,      // one place, where its shots follow each other; meanwhile other files start again
};

/// The decoders for films (output.decoders).
enum class DecoderChoice {
    automatic,  // hardware decoders that work, else software
    processor,  // software only
};

/// The kernel's interface to a graphics card (output.api).
enum class KmsApi {
    best,    // atomic requests if the driver has them
    legacy,  // the calls that are older than atomic requests, even if the driver has both
};

/// The part of this box in a wall of several boxes (wall.role).
enum class WallRole {
    alone,   // it knows of no other box
    lead,    // it decides what the whole wall shows
    follow,  // it draws its part of what the leader decides
};

}  // namespace vitrine
