// Loads tiles. A page that is opened as a file may not read other files, but it may run scripts: each tile is one,
// with a JPEG and zoom fields in base64.
"use strict";

{
    const maxKept = 192; // tiles in memory, 0.6 MB each at 512 x 280 px
    const maxLoading = 6;
    const step = 16; // px between two columns of points
    const rows = 11; // of points
    const head = 20; // bytes of a zoom field before its points
    const minGrowth = 0.02; // smaller ones are rounding errors

    const keyOf = (level, tile) => `${level}/${tile}`;

    const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

    /** The points of a tile on its way to another level, as player/scene/zoom_mesh has them.
     *  Each has 7 numbers: its place on the coarser and on the finer level, px from the origins; u, v; growth, < 0: opaque.
     *  @param left  px of the tile's strip */
    function meshOf(base64, left, isToFiner) {
        if (!base64) return null;
        const field = new DataView(bytesOf(base64).buffer);
        const width = field.getUint16(8, true);
        const height = field.getUint16(10, true);
        const origin = Number(field.getBigInt64(12, true));
        const columns = Math.ceil(width / step) + 1;
        const points = new Float32Array(7 * columns * rows);
        let other = null;
        for (let i = 0; i < columns * rows; ++i) {
            const at = head + 7 * i;
            const column = i % columns;
            const own = [column + 1 === columns ? width : column * step, (Math.floor(i / columns) * height) / (rows - 1)];
            const x = origin + field.getInt32(at, true) / 16;
            const y = field.getUint16(at + 4, true) / 16;
            if (other === null) other = x;
            const growth = isToFiner ? -1 : Math.max(minGrowth, field.getUint8(at + 6) / 32);
            const here = [own[0], own[1]];
            const there = [x - other, y];
            points.set([...(isToFiner ? here : there), ...(isToFiner ? there : here), own[0] / width, own[1] / height, growth], 7 * i);
        }
        return {
            points,
            columns,
            rows,
            coarseOrigin: isToFiner ? left : other,
            finerOrigin: isToFiner ? other : left,
        };
    }

    vitrine.Tiles = class {
        #places;
        #tiles = new Map(); // key -> tile, the one that was wanted longest ago first
        #loading = new Map(); // key -> script
        #failed = new Set();
        #queue = [];

        constructor(places) {
            this.#places = places;
            /** Called when a tile has come. */
            this.onTile = () => {};
            /** Called with each tile that is forgotten. */
            this.onForget = () => {};
            vitrine.addTile = (...tile) => this.#add(...tile);
        }

        get loaded() {
            return this.#tiles.size;
        }

        /** {image, left, width, finer, coarser}, or nothing until it is there. Zoom meshes are null where there are none. */
        get(level, tile) {
            return this.#tiles.get(keyOf(level, tile));
        }

        /** The tiles that the page needs, the most urgent first: [[level, tile]]. */
        want(wanted) {
            this.#queue = [];
            for (const [level, tile] of wanted.slice(0, maxKept).reverse()) {
                const key = keyOf(level, tile);
                const there = this.#tiles.get(key);
                if (there) {
                    this.#tiles.delete(key);
                    this.#tiles.set(key, there);
                } else if (!this.#failed.has(key)) this.#queue.unshift([level, tile]);
            }
            this.#loadNext();
        }

        #loadNext() {
            for (const [level, tile] of this.#queue) {
                if (this.#loading.size >= maxLoading) return;
                const key = keyOf(level, tile);
                if (this.#loading.has(key) || this.#tiles.has(key)) continue;
                const script = document.createElement("script");
                script.src = `${vitrine.folder}${level}/${String(tile).padStart(6, "0")}.js`;
                script.onerror = () => {
                    this.#failed.add(key);
                    this.#finish(key);
                };
                this.#loading.set(key, script);
                document.head.append(script);
            }
        }

        #finish(key) {
            this.#loading.get(key)?.remove();
            this.#loading.delete(key);
            this.#loadNext();
        }

        /** A tile's script calls it. */
        async #add(level, tile, picture, finer, coarser) {
            const key = keyOf(level, tile);
            const left = tile * this.#places.index.tile_width;
            const image = new Image();
            image.src = `data:image/jpeg;base64,${picture}`;
            try {
                await image.decode();
                this.#tiles.set(key, {
                    image,
                    left,
                    width: image.naturalWidth,
                    finer: meshOf(finer, left, true),
                    coarser: meshOf(coarser, left, false),
                });
                this.#forgetOld();
            } catch {
                this.#failed.add(key);
            }
            this.#finish(key);
            this.onTile();
        }

        #forgetOld() {
            for (const [key, tile] of this.#tiles) {
                if (this.#tiles.size <= maxKept) return;
                this.#tiles.delete(key);
                this.onForget(tile);
            }
        }
    };
}
