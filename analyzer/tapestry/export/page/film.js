// The small film above the strip: it plays, or shows the moment that somebody looks at.
"use strict";

vitrine.Film = class {
    #video;
    #looksAt = null; // the moment looked at, seconds; null: the film is where it is
    #before = null; // what was before somebody looked: {time, isPlaying}
    #next = null; // the moment to seek once the present seek is done

    /** @param video  the element */
    constructor(video, source) {
        this.#video = video;
        video.muted = true;
        video.src = source;
        video.addEventListener("seeked", () => {
            if (this.#next !== null) this.#seek(this.#next);
        });
    }

    /** The film's time that is shown, or is on its way. */
    get time() {
        return this.#looksAt ?? this.#video.currentTime;
    }

    get isPlaying() {
        return !this.#video.paused && !this.#video.ended;
    }

    /** Shows the picture of a moment. */
    lookAt(moment) {
        this.#before ??= { time: this.#video.currentTime, isPlaying: this.isPlaying };
        if (moment === this.#looksAt) return;
        this.#looksAt = moment;
        this.#video.pause();
        if (this.#video.seeking) this.#next = moment;
        else this.#seek(moment);
    }

    /** Goes back to what was before somebody looked at a moment. */
    lookAway() {
        const before = this.#before;
        if (!before) return;
        this.#end();
        this.#seek(before.time);
        if (before.isPlaying) this.#play();
    }

    playFrom(moment) {
        this.#end();
        this.#seek(moment);
        this.#play();
    }

    toggle() {
        if (this.isPlaying) this.#video.pause();
        else this.playFrom(this.#video.ended ? 0 : this.time);
    }

    #end() {
        this.#looksAt = null;
        this.#before = null;
    }

    #seek(moment) {
        this.#next = null;
        const end = Number.isFinite(this.#video.duration) ? this.#video.duration - 0.001 : moment;
        this.#video.currentTime = Math.max(0, Math.min(moment, end));
    }

    #play() {
        this.#video.play().catch(() => {}); // another call came first, or the browser wants a click
    }
};
