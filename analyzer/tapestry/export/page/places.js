// Times and places of a tapestry, as base/state/tapestry and player/scene/tapestry/tapestry_view map them.
// A view is {centre: the film's seconds in the middle, level: in [0, levels - 1]}.
"use strict";

window.vitrine = {
    /** Where the page's files are. */
    folder: document.currentScript.src.replace(/[^/]*$/, ""),

    /** tapestry.js calls it with the index. */
    setTapestry(index) {
        vitrine.tapestry = index;
    },
};

vitrine.Places = class {
    #levels;

    /** @param index  of tapestry.js */
    constructor(index) {
        this.index = index;
        this.duration = index.duration_ns / 1e9;
        const piece = Math.min(0.001, this.duration / 4); // half a brick lies beyond the keyframes at the ends
        this.#levels = index.levels.map((level) => ({
            width: level.width,
            times: level.keyframes_ns.map((ns) => Math.min(Math.max(ns / 1e9, piece), this.duration - piece)),
        }));
        this.width = 1; // css px of the window
        this.height = 1; // css px of the strip
    }

    get maxLevel() {
        return this.#levels.length - 1;
    }

    /** css px for one px of the tapestry. */
    get scale() {
        return this.height / this.index.height;
    }

    levelWidth(level) {
        return this.#levels[level].width;
    }

    tiles(level) {
        return Math.ceil(this.#levels[level].width / this.index.tile_width);
    }

    /** The middle of a keyframe, px of the level. */
    #middle(level, keyframe) {
        const { width, times } = this.#levels[level];
        return times.length === 1 ? width / 2 : ((keyframe + 1) * this.index.brick_width) / 2;
    }

    /** Times and places on both sides of keyframe number `after`: [time, time, x, x]. */
    #between(level, after) {
        const { width, times } = this.#levels[level];
        const isFirst = after === 0;
        const isLast = after === times.length;
        return [
            isFirst ? 0 : times[after - 1],
            isLast ? this.duration : times[after],
            isFirst ? 0 : this.#middle(level, after - 1),
            isLast ? width : this.#middle(level, after),
        ];
    }

    /** px of a whole level. */
    xAt(level, time) {
        const [t0, t1, x0, x1] = this.#between(level, countUpTo(this.#levels[level].times, time));
        return line(clamp(time, 0, this.duration), t0, t1, x0, x1);
    }

    /** Seconds. @param x  px of a whole level */
    timeAtX(level, x) {
        const { width, times } = this.#levels[level];
        x = clamp(x, 0, width);
        let after = Math.min(Math.floor((2 * x) / this.index.brick_width), times.length);
        if (times.length === 1) after = x < this.#middle(level, 0) ? 0 : 1;
        const [t0, t1, x0, x1] = this.#between(level, after);
        return line(x, x0, x1, t0, t1);
    }

    /** The whole levels around a level: {coarse, fine, share}. */
    around(level) {
        const within = clamp(level, 0, this.maxLevel);
        const coarse = Math.floor(within);
        return { coarse, fine: Math.min(coarse + 1, this.maxLevel), share: within - coarse };
    }

    /** Between two levels each moment lies between its places on both. px */
    stripX(level, time) {
        const { coarse, fine, share } = this.around(level);
        const x = this.xAt(coarse, time);
        return share === 0 ? x : x + share * (this.xAt(fine, time) - x);
    }

    stripTime(level, x) {
        const { coarse, share } = this.around(level);
        if (share === 0) return this.timeAtX(coarse, x);
        let low = 0;
        let high = this.duration;
        for (let i = 0; i < 50 && high - low > 1e-9; ++i) {
            const middle = (low + high) / 2;
            if (this.stripX(level, middle) <= x) low = middle;
            else high = middle;
        }
        return low;
    }

    /** css px in the window. */
    windowX(view, time) {
        return this.width / 2 + this.scale * (this.stripX(view.level, time) - this.stripX(view.level, view.centre));
    }

    /** Seconds. @param x  css px in the window */
    timeAt(view, x) {
        return this.stripTime(view.level, this.stripX(view.level, view.centre) + (x - this.width / 2) / this.scale);
    }

    /** css px of the whole film. */
    wholeWidth(level) {
        return this.scale * this.stripX(level, this.duration);
    }

    /** The nearest view with as little room beside the film as possible. */
    bounded(view) {
        const level = clamp(view.level, 0, this.maxLevel);
        const whole = this.stripX(level, this.duration);
        const half = Math.min(whole, this.width / this.scale) / 2;
        const x = this.stripX(level, view.centre);
        const within = clamp(x, half, whole - half);
        return { level, centre: within === x ? view.centre : this.stripTime(level, within) };
    }

    /** @param by  css px to the right */
    moved(view, by) {
        const x = this.stripX(view.level, view.centre) - by / this.scale;
        const whole = this.stripX(view.level, this.duration);
        return this.bounded({ level: view.level, centre: this.stripTime(view.level, clamp(x, 0, whole)) });
    }

    /** The view at another level with the same moment at a place of the window. */
    zoomed(view, level, x) {
        const kept = this.timeAt(view, x);
        level = clamp(level, 0, this.maxLevel);
        const centre = this.stripX(level, kept) - (x - this.width / 2) / this.scale;
        return this.bounded({ level, centre: this.stripTime(level, centre) });
    }

    /** The difference of level, from this one on, that makes the strip wider by this factor. */
    levelsFor(level, factor) {
        const { coarse, fine } = this.around(level);
        const other = coarse === fine && coarse > 0 ? coarse - 1 : coarse;
        const ratio = this.#levels[fine].width / this.#levels[other].width;
        return ratio > 1 ? Math.log(factor) / Math.log(ratio) : 0;
    }

    /** The numbers of a level's tiles that may be seen, with some more on both sides. @param more  css px */
    tilesInView(view, level, more = 0) {
        const reach = view.level === level ? 0 : this.index.brick_width; // px that zoom fields may move points
        const tile = (x, by) =>
            clamp(Math.floor((this.xAt(level, this.timeAt(view, x)) + by) / this.index.tile_width), 0, this.tiles(level) - 1);
        const numbers = [];
        for (let i = tile(-more - reach * this.scale, -reach); i <= tile(this.width + more + reach * this.scale, reach); ++i)
            numbers.push(i);
        return numbers;
    }

    /** A tile cut at the keyframes between which its way to the next level is a line: [{first, last, left, right}],
     *  shares of its width and css px in the window. */
    pieces(view, level, tile) {
        const { fine } = this.around(view.level);
        const bent = Math.max(level, fine);
        const begin = tile * this.index.tile_width;
        const end = Math.min(begin + this.index.tile_width, this.levelWidth(level));
        const cuts = [begin];
        if (view.level !== level) {
            const times = this.#levels[bent].times;
            for (let i = countUpTo(times, this.timeAtX(level, begin)); i < times.length; ++i) {
                const x = this.xAt(level, times[i]);
                if (x >= end) break;
                if (x > begin) cuts.push(x);
            }
        }
        cuts.push(end);
        const places = cuts.map((x) => this.windowX(view, this.timeAtX(level, x)));
        const share = (x) => (x - begin) / (end - begin);
        return cuts.slice(1).map((x, i) => ({ first: share(cuts[i]), last: share(x), left: places[i], right: places[i + 1] }));
    }
};

function clamp(value, min, max) {
    return Math.max(min, Math.min(value, max));
}

/** The value at x of a line from (x0, y0) to (x1, y1). */
function line(x, x0, x1, y0, y1) {
    return x1 > x0 ? y0 + ((y1 - y0) * (x - x0)) / (x1 - x0) : y0;
}

/** How many of these numbers, in order, are up to a value. */
function countUpTo(numbers, value) {
    let low = 0;
    let high = numbers.length;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (numbers[middle] <= value) low = middle + 1;
        else high = middle;
    }
    return low;
}
