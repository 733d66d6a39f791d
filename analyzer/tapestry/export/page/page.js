// What a visitor does, and what is seen of it. The mouse: hovering looks at a moment, dragging moves the strip, a
// click plays, the wheel zooms. Fingers: dragging moves the strip and shows the moment below the finger, letting go
// plays from there, two fingers zoom; a finger that has rested goes over the strip. Arrows, Space and Enter, too.
"use strict";

{
    const dragBegin = 4; // css px
    const restTime = 400; // ms
    const quietWay = 24; // css px that the mouse goes after a click until it looks again
    const wheelFactor = 0.002; // per px of the wheel
    const pinchFactor = 0.01; // the same for a pinch of a touch pad
    const lineHeight = 16; // px of the wheel that a line of it means
    const settleAfter = 250; // ms after the wheel's last turn
    const slack = 0.1; // of a level: so far beyond a whole level the strip goes back to it
    const zoomTime = 0.12; // s in which 63 % of a zoom is done
    const panTime = 0.12;
    const followTime = 0.35;
    const firstStand = 0.1; // shares of the width between which what plays goes through a strip that rests
    const lastStand = 0.7;
    const keyWay = 0.3; // share of the width

    const inWords = (seconds) => {
        const whole = Math.floor(seconds + 1e-6);
        const two = (number) => String(number).padStart(2, "0");
        const hours = Math.floor(whole / 3600);
        const minutes = Math.floor(whole / 60) % 60;
        return hours > 0 ? `${hours}:${two(minutes)}:${two(whole % 60)}` : `${minutes}:${two(whole % 60)}`;
    };

    class Page {
        constructor(index) {
            this.strip = document.getElementById("strip");
            this.places = new vitrine.Places(index);
            this.tiles = new vitrine.Tiles(this.places);
            this.drawing = vitrine.drawingOn(document.getElementById("tapestry"), location.hash === "#plain");
            this.film = new vitrine.Film(document.getElementById("film"), vitrine.folder + index.film.file);
            this.view = { centre: 0, level: 0 };
            this.frames = 0; // drawn so far
            this.zoom = null; // {to, at}: a level, css px
            this.pan = 0; // css px to the right that are still to go
            this.wheel = null; // {time, way}: its last turn, ms
            this.hold = "free"; // free: the strip goes along with the film; held; away: somebody moved it away
            this.pointers = new Map(); // id -> {x, y}
            this.press = null; // of one pointer: {id, from, at, since, isMoved, goesOver}
            this.hover = null; // css px
            this.quiet = null; // css px of the last click, while the mouse stays near it
            this.isStale = true;
            this.last = 0;
            this.tiles.onTile = () => (this.isStale = true);
            this.tiles.onForget = (tile) => this.drawing.forget(tile);
            this.drawing.onRestored = () => (this.isStale = true);
        }

        begin() {
            document.title = this.places.index.name;
            new ResizeObserver(() => this.resize()).observe(this.strip);
            this.resize();
            const on = (name, handle) => this.strip.addEventListener(name, (event) => handle.call(this, event), { passive: false });
            on("pointerdown", this.pointerDown);
            on("pointermove", this.pointerMove);
            on("pointerup", this.pointerUp);
            on("pointercancel", this.pointerUp);
            on("pointerleave", this.pointerLeave);
            on("wheel", this.turnWheel);
            on("gesturestart", this.padPinch);
            on("gesturechange", this.padPinch);
            document.addEventListener("keydown", (event) => this.key(event));
            const film = document.getElementById("film");
            film.addEventListener("click", () => this.film.toggle());
            film.addEventListener("error", () => say("This browser cannot play the film of this page."));
            if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.film.playFrom(0);
            requestAnimationFrame((now) => this.frame(now));
        }

        /** True: all tiles in view are there. */
        get isWhole() {
            const { coarse, fine, share } = this.places.around(this.view.level);
            return [coarse, share > 0 ? fine : coarse].every((level) =>
                this.places.tilesInView(this.view, level).every((tile) => this.tiles.get(level, tile)));
        }

        resize() {
            this.ratio = devicePixelRatio || 1;
            this.places.width = Math.max(1, this.strip.clientWidth);
            this.places.height = Math.max(1, this.strip.clientHeight);
            const canvas = this.drawing.canvas;
            canvas.width = Math.round(this.places.width * this.ratio);
            canvas.height = Math.round(this.places.height * this.ratio);
            this.show(this.places.bounded(this.view));
            this.isStale = true;
        }

        show(view) {
            if (view.centre === this.view.centre && view.level === this.view.level) return;
            this.view = view;
            this.isStale = true;
        }

        zoomTo(level, at) {
            this.zoom = { to: Math.max(0, Math.min(level, this.places.maxLevel)), at };
        }

        placeOf(event) {
            return event.clientX - this.strip.getBoundingClientRect().left;
        }

        lookAt(x) {
            this.film.lookAt(this.places.timeAt(this.view, x));
        }

        // Pointers

        pointerDown(event) {
            if (event.button !== 0 || this.pointers.size === 2) return;
            try {
                this.strip.setPointerCapture(event.pointerId);
            } catch {
                // a pointer that is gone already, or a test's
            }
            const x = this.placeOf(event);
            this.pointers.set(event.pointerId, { x, y: event.clientY });
            this.hold = "held";
            this.zoom = this.wheel = this.hover = null;
            this.pan = 0;
            if (this.pointers.size === 2) {
                this.press = null;
                return this.film.lookAway();
            }
            this.press = { id: event.pointerId, from: x, at: x, since: event.timeStamp, isMoved: false, goesOver: false };
            this.lookAt(x);
        }

        pointerMove(event) {
            const pointer = this.pointers.get(event.pointerId);
            const x = this.placeOf(event);
            if (this.pointers.size === 2 && pointer) return this.pinch(pointer, x, event.clientY);
            if (pointer) Object.assign(pointer, { x, y: event.clientY });
            if (this.press?.id === event.pointerId) return this.drag(x, event);
            if (this.pointers.size > 0 || event.pointerType === "touch") return;
            if (this.quiet !== null && Math.abs(x - this.quiet) < quietWay) return;
            this.quiet = null;
            this.hover = x;
            this.lookAt(x);
        }

        drag(x, event) {
            const press = this.press;
            if (!press.isMoved) {
                if (Math.abs(x - press.from) <= dragBegin) return;
                press.isMoved = true;
                press.goesOver = event.pointerType === "touch" && event.timeStamp - press.since > restTime;
                this.strip.classList.add("held");
            }
            if (!press.goesOver) this.show(this.places.moved(this.view, x - press.at));
            press.at = x;
            this.lookAt(x);
        }

        pinch(pointer, x, y) {
            const [one, other] = this.pointers.values();
            const middle = () => (one.x + other.x) / 2;
            const width = () => Math.max(8, Math.hypot(one.x - other.x, one.y - other.y));
            const [middleBefore, widthBefore] = [middle(), width()];
            Object.assign(pointer, { x, y });
            const moved = this.places.moved(this.view, middle() - middleBefore);
            const more = this.places.levelsFor(moved.level, width() / widthBefore);
            this.show(this.places.zoomed(moved, moved.level + more, middle()));
            this.pinchedAt = middle();
        }

        pointerUp(event) {
            if (!this.pointers.delete(event.pointerId)) return;
            if (this.pointers.size === 1) return this.zoomTo(Math.round(this.view.level), this.pinchedAt ?? this.places.width / 2);
            this.strip.classList.remove("held");
            this.hold = "free";
            if (this.press?.id !== event.pointerId) return;
            this.press = null;
            if (event.type === "pointercancel") return this.film.lookAway();
            const x = this.placeOf(event);
            this.quiet = x;
            this.film.playFrom(this.places.timeAt(this.view, x));
        }

        pointerLeave(event) {
            if (this.pointers.has(event.pointerId)) return;
            this.hover = this.quiet = null;
            if (!this.press) this.film.lookAway();
        }

        // The wheel, touch pads and keys

        turnWheel(event) {
            event.preventDefault();
            const unit = event.deltaMode === 1 ? lineHeight : event.deltaMode === 2 ? this.places.width : 1;
            const across = (event.shiftKey && event.deltaX === 0 ? event.deltaY : event.deltaX) * unit;
            if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY))
                return this.show(this.places.moved(this.view, -across));
            this.zoomBy(Math.exp(-event.deltaY * unit * (event.ctrlKey ? pinchFactor : wheelFactor)), this.placeOf(event), event.timeStamp);
        }

        /** A pinch on a touch pad in Safari. */
        padPinch(event) {
            event.preventDefault();
            if (event.type === "gesturechange") this.zoomBy(event.scale / this.padScale, this.placeOf(event), event.timeStamp);
            this.padScale = event.scale;
        }

        zoomBy(factor, at, time) {
            if (this.pointers.size > 0 || factor === 1) return;
            const from = this.zoom ? this.zoom.to : this.view.level;
            this.zoomTo(from + this.places.levelsFor(from, factor), at);
            this.wheel = { time, way: Math.sign(factor - 1) };
        }

        key(event) {
            if (event.ctrlKey || event.altKey || event.metaKey) return;
            const middle = this.places.width / 2;
            const zoomBy = (levels) => this.zoomTo(Math.round(this.zoom ? this.zoom.to : this.view.level) + levels, middle);
            const moves = {
                ArrowLeft: () => (this.pan += keyWay * this.places.width),
                ArrowRight: () => (this.pan -= keyWay * this.places.width),
                ArrowUp: () => zoomBy(1),
                ArrowDown: () => zoomBy(-1),
                "+": () => zoomBy(1),
                "-": () => zoomBy(-1),
                Home: () => this.show(this.places.bounded({ ...this.view, centre: 0 })),
                End: () => this.show(this.places.bounded({ ...this.view, centre: this.places.duration })),
                Enter: () => this.film.playFrom(this.view.centre),
                " ": () => this.film.toggle(),
            };
            if (!moves[event.key]) return;
            event.preventDefault();
            moves[event.key]();
        }

        // Each frame

        frame(now) {
            const passed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
            this.last = now;
            if (devicePixelRatio !== this.ratio) this.resize();
            this.goOnZooming(now, passed);
            this.goOnPanning(passed);
            this.keepInView(passed);
            if (this.hover !== null && this.isStale) this.lookAt(this.hover);
            if (this.isStale) this.draw();
            this.placeLine();
            requestAnimationFrame((next) => this.frame(next));
        }

        goOnZooming(now, passed) {
            if (this.wheel && now - this.wheel.time > settleAfter) {
                const level = this.zoom ? this.zoom.to : this.view.level;
                this.zoomTo(this.wheel.way > 0 ? Math.ceil(level - slack) : Math.floor(level + slack), this.zoom?.at ?? this.wheelAt);
                this.wheel = null;
            }
            if (!this.zoom) return;
            this.wheelAt = this.zoom.at;
            const rest = this.zoom.to - this.view.level;
            const isDone = Math.abs(rest) < 0.003;
            const level = isDone ? this.zoom.to : this.view.level + rest * (1 - Math.exp(-passed / zoomTime));
            this.show(this.places.zoomed(this.view, level, this.zoom.at));
            if (isDone) this.zoom = null;
        }

        goOnPanning(passed) {
            if (this.pan === 0) return;
            const way = Math.abs(this.pan) < 1 ? this.pan : this.pan * (1 - Math.exp(-passed / panTime));
            this.pan -= way;
            const before = this.view;
            this.show(this.places.moved(this.view, way));
            if (this.view === before && passed > 0) this.pan = 0;
        }

        /** The strip goes along with what plays, unless somebody has moved it away from there. */
        keepInView(passed) {
            if (this.hold === "held") return;
            const width = this.places.width;
            const x = this.places.windowX(this.view, this.film.time);
            const isSeen = x >= 0 && x <= width;
            const isMoving = this.zoom !== null || this.pan !== 0;
            if (isSeen || isMoving) this.hold = isSeen ? "free" : "away";
            if (isMoving || this.hold === "away" || !this.film.isPlaying) return;
            const beyond = x - Math.max(firstStand * width, Math.min(x, lastStand * width));
            if (beyond !== 0) this.show(this.places.moved(this.view, -beyond * (1 - Math.exp(-passed / followTime))));
        }

        /** The tiles in view first, then those beside it, then those of the levels next to it. */
        wanted() {
            const { coarse, fine, share } = this.places.around(this.view.level);
            const near = share > 0 ? [coarse, fine] : [coarse];
            const beside = [Math.min(fine + (share > 0 ? 1 : 0), this.places.maxLevel), Math.max(coarse - 1, 0), 0];
            const of = (level, more) => this.places.tilesInView(this.view, level, more).map((tile) => [level, tile]);
            const all = [...near.map((level) => of(level, 0)), ...near.map((level) => of(level, this.places.width / 2)),
                ...beside.map((level) => of(level, 0))].flat();
            return [...new Map(all.map((tile) => [tile.join("/"), tile])).values()];
        }

        draw() {
            this.isStale = false;
            this.tiles.want(this.wanted());
            this.drawing.draw({ places: this.places, view: this.view, tiles: this.tiles, ratio: this.ratio });
            ++this.frames;
        }

        placeLine() {
            const time = this.film.time;
            const x = this.places.windowX(this.view, time);
            const isSeen = x >= 0 && x <= this.places.width;
            const line = document.getElementById("line");
            const words = document.getElementById("time");
            line.hidden = words.hidden = !isSeen;
            if (!isSeen) return;
            line.style.transform = `translateX(${x}px)`;
            words.textContent = inWords(time);
            const room = this.places.width - words.offsetWidth;
            words.style.transform = `translateX(${Math.max(0, Math.min(x - words.offsetWidth / 2, room))}px)`;
        }
    }

    function say(words) {
        const trouble = document.getElementById("trouble");
        trouble.textContent = words;
        trouble.hidden = false;
    }

    if (vitrine.tapestry) {
        vitrine.page = new Page(vitrine.tapestry);
        vitrine.page.begin();
    } else {
        say("Files of this page are missing.");
    }
}
