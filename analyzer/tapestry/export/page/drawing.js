// Draws the strip: by WebGL 2 as the player does (player/render/zoom_layer), else on a plain canvas, where two levels
// are bent by their times and fade into one another.
"use strict";

{
    const blendBegin = 0.2; // position between two levels from which the finer one is visible where they fade
    const blendEnd = 0.8;

    const vertexShader = `#version 300 es
        precision highp float;
        layout(location = 0) in vec4 places;  // px of both strips
        layout(location = 1) in vec3 texel;   // u, v, growth
        uniform vec2 offset, size;            // px of the canvas
        uniform vec2 scale;
        uniform float share;
        out highp vec2 uv;
        out mediump float opacity;
        void main() {
            vec2 place = offset + scale * mix(places.xy, places.zw, share);
            uv = texel.xy;
            opacity = texel.z < 0.0 ? 1.0 : share / mix(texel.z, 1.0, share);
            gl_Position = vec4(2.0 * place.x / size.x - 1.0, 1.0 - 2.0 * place.y / size.y, 0.0, 1.0);
        }`;

    const fragmentShader = `#version 300 es
        precision mediump float;
        uniform sampler2D picture;
        in highp vec2 uv;
        in mediump float opacity;
        out vec4 pixel;
        void main() {
            pixel = vec4(texture(picture, uv).rgb, opacity);
        }`;

    const eased = (share) => {
        const within = Math.max(0, Math.min(share, 1));
        return within * within * (3 - 2 * within);
    };

    /** All tiles of a level in view, or nothing where one is missing. */
    function tilesOf(strip, level) {
        const found = strip.places.tilesInView(strip.view, level).map((number) => [number, strip.tiles.get(level, number)]);
        return found.every(([, tile]) => tile) ? found : null;
    }

    /** The pieces of a level's tiles that are there: calls draw(tile, piece). */
    function eachPiece(strip, level, draw) {
        for (const number of strip.places.tilesInView(strip.view, level)) {
            const tile = strip.tiles.get(level, number);
            if (!tile) continue;
            for (const piece of strip.places.pieces(strip.view, level, number))
                if (piece.right > 0 && piece.left < strip.places.width) draw(tile, piece);
        }
    }

    class GlDrawing {
        #gl;
        #program;
        #at = {};
        #buffers = new Map(); // mesh -> {array, count}
        #textures = new Map(); // tile -> texture
        #indices = new Map(); // columns -> buffer
        #square;

        constructor(canvas) {
            this.canvas = canvas;
            this.#gl = canvas.getContext("webgl2", { alpha: false, antialias: false });
            if (!this.#gl) throw new Error("no WebGL 2");
            this.#begin();
            canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
            canvas.addEventListener("webglcontextrestored", () => {
                for (const kept of [this.#buffers, this.#textures, this.#indices]) kept.clear();
                this.#begin();
                this.onRestored();
            });
            this.onRestored = () => {};
        }

        get kind() {
            return "webgl";
        }

        #begin() {
            const gl = this.#gl;
            this.#program = gl.createProgram();
            for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
                const shader = gl.createShader(kind);
                gl.shaderSource(shader, text);
                gl.compileShader(shader);
                gl.attachShader(this.#program, shader);
            }
            gl.linkProgram(this.#program);
            if (!gl.getProgramParameter(this.#program, gl.LINK_STATUS) && !gl.isContextLost())
                throw new Error(gl.getProgramInfoLog(this.#program));
            for (const name of ["offset", "size", "scale", "share"])
                this.#at[name] = gl.getUniformLocation(this.#program, name);
            gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
            this.#square = gl.createBuffer();
        }

        forget(tile) {
            const gl = this.#gl;
            gl.deleteTexture(this.#textures.get(tile) ?? null);
            this.#textures.delete(tile);
            for (const mesh of [tile.finer, tile.coarser]) {
                const made = this.#buffers.get(mesh);
                if (!made) continue;
                gl.deleteVertexArray(made.array);
                gl.deleteBuffer(made.points);
                this.#buffers.delete(mesh);
            }
        }

        #bind(tile) {
            const gl = this.#gl;
            let texture = this.#textures.get(tile);
            if (texture) return gl.bindTexture(gl.TEXTURE_2D, texture);
            texture = gl.createTexture();
            this.#textures.set(tile, texture);
            gl.bindTexture(gl.TEXTURE_2D, texture);
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, gl.RGB, gl.UNSIGNED_BYTE, tile.image);
            gl.generateMipmap(gl.TEXTURE_2D);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_LINEAR);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        }

        #attributes(points) {
            const gl = this.#gl;
            gl.bindBuffer(gl.ARRAY_BUFFER, points);
            gl.vertexAttribPointer(0, 4, gl.FLOAT, false, 28, 0);
            gl.vertexAttribPointer(1, 3, gl.FLOAT, false, 28, 16);
            gl.enableVertexAttribArray(0);
            gl.enableVertexAttribArray(1);
        }

        #trianglesOf(mesh) {
            const gl = this.#gl;
            let made = this.#indices.get(mesh.columns);
            if (!made) {
                const numbers = [];
                for (let row = 0; row + 1 < mesh.rows; ++row)
                    for (let column = 0; column + 1 < mesh.columns; ++column) {
                        const one = row * mesh.columns + column;
                        const below = one + mesh.columns;
                        numbers.push(one, one + 1, below + 1, one, below + 1, below);
                    }
                made = { buffer: gl.createBuffer(), count: numbers.length };
                gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, made.buffer);
                gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(numbers), gl.STATIC_DRAW);
                this.#indices.set(mesh.columns, made);
            }
            return made;
        }

        #arrayOf(mesh) {
            const gl = this.#gl;
            let made = this.#buffers.get(mesh);
            if (made) return made;
            const triangles = this.#trianglesOf(mesh);
            made = { array: gl.createVertexArray(), points: gl.createBuffer(), count: triangles.count };
            gl.bindVertexArray(made.array);
            gl.bindBuffer(gl.ARRAY_BUFFER, made.points);
            gl.bufferData(gl.ARRAY_BUFFER, mesh.points, gl.STATIC_DRAW);
            this.#attributes(made.points);
            gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, triangles.buffer);
            gl.bindVertexArray(null);
            this.#buffers.set(mesh, made);
            return made;
        }

        /** @param strip  {places, view, tiles, ratio}, ratio: px of the canvas for a css px */
        draw(strip) {
            const gl = this.#gl;
            const { coarse, share } = strip.places.around(strip.view.level);
            gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
            gl.clearColor(0, 0, 0, 1);
            gl.clear(gl.COLOR_BUFFER_BIT);
            gl.useProgram(this.#program);
            gl.uniform2f(this.#at.size, gl.drawingBufferWidth, gl.drawingBufferHeight);
            gl.disable(gl.BLEND);
            const isZoom = share > 0 && strip.places.index.levels[coarse + 1].zoom;
            const level = isZoom ? coarse : Math.round(strip.view.level);
            for (let under = 0; under <= level; ++under)
                if (under === level ? !isZoom : !tilesOf(strip, level)) this.#drawPieces(strip, under);
            if (!isZoom) return;
            this.#drawZoom(strip, coarse, "finer", share);
            gl.enable(gl.BLEND);
            this.#drawZoom(strip, coarse + 1, "coarser", share);
        }

        #drawZoom(strip, level, way, share) {
            const gl = this.#gl;
            const { places, view, ratio } = strip;
            const scale = places.scale * ratio;
            gl.uniform2f(this.#at.scale, scale, scale);
            gl.uniform1f(this.#at.share, share);
            const centre = places.stripX(view.level, view.centre);
            for (const number of places.tilesInView(view, level)) {
                const tile = strip.tiles.get(level, number);
                const mesh = tile?.[way];
                if (!mesh) continue;
                const origin = mesh.coarseOrigin + share * (mesh.finerOrigin - mesh.coarseOrigin);
                gl.uniform2f(this.#at.offset, (places.width / 2) * ratio + scale * (origin - centre), 0);
                this.#bind(tile);
                const made = this.#arrayOf(mesh);
                gl.bindVertexArray(made.array);
                gl.drawElements(gl.TRIANGLES, made.count, gl.UNSIGNED_SHORT, 0);
            }
            gl.bindVertexArray(null);
        }

        #drawPieces(strip, level) {
            const gl = this.#gl;
            this.#attributes(this.#square);
            gl.uniform1f(this.#at.share, 0);
            gl.uniform2f(this.#at.scale, strip.ratio, gl.drawingBufferHeight);
            gl.uniform2f(this.#at.offset, 0, 0);
            eachPiece(strip, level, (tile, { first, last, left, right }) => {
                this.#bind(tile);
                const point = (x, y, u) => [x, y, x, y, u, y, -1];
                const points = [...point(left, 0, first), ...point(right, 0, last), ...point(left, 1, first), ...point(right, 1, last)];
                gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(points), gl.STREAM_DRAW);
                gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
            });
        }
    }

    class PlainDrawing {
        #context;

        constructor(canvas) {
            this.canvas = canvas;
            this.#context = canvas.getContext("2d", { alpha: false });
            this.onRestored = () => {};
        }

        get kind() {
            return "plain";
        }

        forget() {}

        draw(strip) {
            const { coarse, fine, share } = strip.places.around(strip.view.level);
            const alpha = eased((share - blendBegin) / (blendEnd - blendBegin));
            this.#context.globalAlpha = 1;
            this.#context.fillStyle = "#000";
            this.#context.fillRect(0, 0, this.canvas.width, this.canvas.height);
            for (let under = 0; under < coarse && !tilesOf(strip, coarse); ++under) this.#drawLevel(strip, under, 1);
            this.#drawLevel(strip, coarse, 1);
            if (alpha > 0) this.#drawLevel(strip, fine, alpha);
        }

        #drawLevel(strip, level, alpha) {
            this.#context.globalAlpha = alpha;
            eachPiece(strip, level, (tile, { first, last, left, right }) => {
                const from = Math.round(left * strip.ratio);
                const to = Math.round(right * strip.ratio);
                if (to > from)
                    this.#context.drawImage(tile.image, first * tile.width, 0, (last - first) * tile.width,
                        tile.image.naturalHeight, from, 0, to - from, this.canvas.height);
            });
        }
    }

    /** @param isPlain  true: without WebGL, even where there is one */
    vitrine.drawingOn = (canvas, isPlain) => {
        try {
            if (!isPlain) return new GlDrawing(canvas);
        } catch (error) {
            console.warn(error);
        }
        try {
            return new PlainDrawing(canvas);
        } catch { // the canvas has a context of the other kind already
            const other = canvas.cloneNode();
            canvas.replaceWith(other);
            return new PlainDrawing(other);
        }
    };
}
