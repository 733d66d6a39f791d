#pragma once

namespace vitrine {

// The settings that are one of a few words, each as an enum. setting_keys.cpp holds the words.

/// The shape of the region around what matters in a shot (analyzer.region).
enum class RegionMode {
    min_area,  // the smallest convex region that holds enough of the saliency
    hull,      // the paper's: convex hull of the most salient pixels that together hold enough
};

/// The energy that a layout minimises (layout.energy).
enum class EnergyMode {
    screen,  // share of the screen not covered by I-Regions, with escape from local minima
    paper,   // eq. 3.4 by descent alone, for reproduction
};

/// The places that items may take (layout.order).
enum class LayoutOrder {
    free,     // each stands where it fits best
    reading,  // each is read after the one before, in lines from the top and from left to right
};

/// The way in which the space between I-Regions is shared out (layout.cells).
enum class CellMethod {
    exact,    // Voronoi diagram of the regions' outlines
    sampled,  // the paper's: Voronoi diagram of points along the outlines
};

/// The kind of wall (layout.mode).
enum class WallMode {
    fit,  // all slots on one screen
    pan,  // a ribbon as high as the screen that passes by
};

/// The role of folders in a layout (layout.folders).
enum class FolderMode {
    flat,    // none
    nested,  // the items of one folder stand together
};

/// The order in which shots come to the wall (show.order). The shots of one film always come in time order.
enum class ShotOrder {
    shuffle,
    name,    // by path
    newest,  // by modification time, the newest first
};

/// The way in which a film with several shots shares the wall (show.film).
enum class FilmShow {
    side_by_side,  // its shots may stand beside each other; each shot of the catalogue comes once before
                   // any comes again
    sequence,      // it has one place, where its shots follow each other, while other files begin again
};

/// The decoders that films are played with (output.decoders).
enum class DecoderChoice {
    automatic,  // the hardware's where there are some that work
    processor,  // software only
};

/// The interface by which a graphics card is told what to show (output.api).
enum class KmsApi {
    best,    // atomic requests where the driver has them
    legacy,  // the calls that are older than atomic requests, also where the driver has both
};

}  // namespace vitrine
