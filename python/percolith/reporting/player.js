// SPDX-License-Identifier: BSD-3-Clause
// Goes through the times of the run: by hand on the slider, or by itself to the last one.
const PLAYED = 6000, SHORTEST = 250, LONGEST = 800;  // ms of all times, and of each

class Player {
  constructor() {
    Object.assign(this, { slider: byId("view-time"), button: byId("view-play"), timer: null });
    this.slider.value = state.frame;  // a browser may keep what was chosen before a reload
    this.slider.addEventListener("input", () => { this.stop(); this.go(this.slider.valueAsNumber); });
    this.button.addEventListener("click", () => this.toggle());
    state.alone = byId("view-alone").checked;
    showBars();
    byId("view-alone").addEventListener("change", (event) => {
      state.alone = event.target.checked;
      showBars();
      redraw();
    });
    this.tell();
  }

  get last() { return about.frames.length - 1; }

  async go(number) {
    try {
      await show({ frame: Math.min(this.last, Math.max(0, number)) });
    } catch (error) {
      this.stop();
      wanted.frame = state.frame;
      this.tell();
      tellFailure(error);
    }
  }

  // From the time that is on its way, so that keys pressed fast all count.
  step(by) {
    this.stop();
    return this.go(wanted.frame + by);
  }

  tell() {
    const frame = about.frames[state.frame];
    this.slider.value = state.frame;
    this.slider.setAttribute("aria-valuetext", frame.moment);
    byId("view-moment").textContent = frame.moment;
  }

  toggle() {
    if (this.timer === null) this.play();
    else this.stop();
  }

  async play() {
    this.button.textContent = "Pause";
    byId("view-moment").setAttribute("aria-live", "off");  // else each time is read out
    this.timer = 0;
    if (state.frame === this.last) await this.go(0);
    if (this.timer === 0) this.wait();
  }

  // The next time waits until the one before is shown.
  wait() {
    const stay = Math.min(LONGEST, Math.max(SHORTEST, PLAYED / about.frames.length));
    const timer = this.timer = setTimeout(async () => {
      await this.go(state.frame + 1);
      if (this.timer !== timer) return;
      if (state.frame === this.last) this.stop();
      else this.wait();
    }, stay);
  }

  stop() {
    clearTimeout(this.timer);
    this.timer = null;
    this.button.textContent = "Play";
    byId("view-moment").setAttribute("aria-live", "polite");
  }
}
