# SPDX-License-Identifier: BSD-3-Clause
"""The page of `percolith report` in a browser: it fetches nothing, draws, and answers the mouse."""

import base64
import io

import numpy as np
import pytest
from conftest import SIZE
from PIL import Image

READY = "document.getElementById('view-canvas').dataset.state !== undefined"
# The pixels of the view as rows of red, green, blue and opacity, from its lower left corner.
PIXELS = """(() => {
  draw();
  const all = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE,
                all);
  return btoa(Array.from(all, (byte) => String.fromCharCode(byte)).join(""));
})()"""
PAINTED = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"


def opened(browser, address):
    browser.open(address)
    browser.wait_for(READY)
    assert browser.evaluate("document.getElementById('view-canvas').dataset.state") == "ready"
    browser.evaluate("document.querySelector('.controls').scrollIntoView()")
    return browser


def pixels(browser) -> np.ndarray:
    return np.frombuffer(base64.b64decode(browser.evaluate(PIXELS)), np.uint8).reshape(-1, 4)


def window_place(browser, x: float, y: float) -> tuple[float, float]:
    """Where in the window a place of the undeformed model (m) is."""
    return tuple(browser.evaluate(f"""(() => {{
      const box = canvas.getBoundingClientRect();
      return [box.left + box.width / 2 + ({x} - about.origin[0] - state.centre[0]) * state.zoom,
              box.top + box.height / 2 - ({y} - about.origin[1] - state.centre[1]) * state.zoom];
    }})()"""))


def tip_at(browser, x: float, y: float) -> list[str]:
    """What the page says while the mouse points at a place of the model (m)."""
    browser.mouse("mouseMoved", *window_place(browser, x, y))
    browser.evaluate(PAINTED)
    if browser.evaluate("document.getElementById('view-tip').hidden"):
        return []
    return browser.evaluate("document.getElementById('view-tip').textContent").split("\n")


def choose(browser, kind: str, name: str) -> None:
    browser.evaluate(f"""(() => {{
      const list = document.getElementById("view-{kind}");
      list.value = "{name}";
      list.dispatchEvent(new Event("change"));
    }})()""")
    browser.wait_for(f"(state.{kind}?.name ?? '') === '{name}'")
    browser.evaluate(PAINTED)


@pytest.mark.parametrize("name", ["flow", "mechanics", "coupled"])
def test_the_page_draws_and_fetches_nothing(browser, pages, name):
    opened(browser, pages[name])
    assert browser.problems == []
    assert [address for address in browser.requests if not address.startswith("data:")] == [
        pages[name]]
    seen = pixels(browser)
    drawn = (seen[:, :3] < 250).any(axis=1)
    assert 0.1 < drawn.mean() < 0.999
    assert len(np.unique(seen, axis=0)) > 50
    picture = np.asarray(Image.open(io.BytesIO(browser.screenshot())))
    assert len(np.unique(picture.reshape(-1, picture.shape[2]), axis=0)) > 50


def test_cracks_of_flow_lie_where_they_are(browser, pages):
    opened(browser, pages["flow"])
    shown = pixels(browser)
    choose(browser, "cracks", "")
    width, height, zoom, centre = browser.evaluate(
        "[gl.drawingBufferWidth, gl.drawingBufferHeight, state.zoom, "
        "about.origin[1] + state.centre[1]]")
    changed = (shown != pixels(browser)).any(axis=1).reshape(height, width)
    y = centre + (np.flatnonzero(changed.any(axis=1)) + 0.5 - height / 2) / zoom
    assert len(y) > 0
    assert np.abs(y - 1).max() < 0.1


def test_values_under_the_mouse(browser, pages):
    opened(browser, pages["flow"])
    assert tip_at(browser, 0.5 * SIZE, 0.8 * SIZE)[0] == "Pressure: 1 MPa"
    assert tip_at(browser, 0.25 * SIZE, 0.8 * SIZE)[0].startswith("Pressure: 0.5")
    assert tip_at(browser, 0.5 * SIZE, 0.8 * SIZE)[1].startswith("x = 2")
    assert tip_at(browser, -0.2 * SIZE, 0.5 * SIZE) == []
    crack = tip_at(browser, 1.75, 1.0)
    assert crack[2:] == ["On a crack", "Pressure in cracks: 0.5 MPa", "Saturation of cracks: 1",
                         "Aperture of cracks, hydraulic: 200 µm",
                         "Flux along cracks: 3 × 10⁻⁶ m²/s"]
    choose(browser, "rock", "region")
    assert tip_at(browser, 2.1, 3.1)[0] == "Regions: region 1"
    choose(browser, "cracks", "")
    assert "On a crack" not in tip_at(browser, 1.75, 1.0)
    assert browser.problems == []


def test_moving_and_zooming_keep_what_is_under_the_mouse(browser, pages):
    opened(browser, pages["flow"])
    whole = pixels(browser)
    # Events of the wheel have whole numbers of pixels.
    place = tuple(map(round, window_place(browser, 1.2, 2.7)))
    under = "placeAt({}, {})".format(*place)
    before = browser.evaluate(under)
    for _ in range(4):
        browser.mouse("mouseWheel", *place, deltaX=0, deltaY=-200)
    browser.wait_for("state.zoom > 3 * canvas.getBoundingClientRect().height / about.size[1]")
    assert browser.evaluate(under) == pytest.approx(before, abs=1e-3)
    browser.mouse("mousePressed", *place, button="left", buttons=1, clickCount=1)
    browser.mouse("mouseMoved", place[0] + 40, place[1] + 30, button="left", buttons=1)
    browser.mouse("mouseReleased", place[0] + 40, place[1] + 30, button="left")
    moved = "placeAt({}, {})".format(place[0] + 40, place[1] + 30)
    assert browser.evaluate(moved) == pytest.approx(before, abs=1e-3)
    assert (pixels(browser) != whole).any()
    browser.evaluate("document.getElementById('view-whole').click()")
    assert (pixels(browser) == whole).all()


def test_fields_cracks_and_displacements_change_the_picture(browser, pages):
    opened(browser, pages["coupled"])
    seen = [pixels(browser)]
    for kind, name in (("rock", "displacement"), ("cracks", "mode"), ("cracks", "")):
        choose(browser, kind, name)
        seen.append(pixels(browser))
    assert "tensile" in browser.evaluate("""(choose("cracks", "mode").then(
        () => document.getElementById("view-cracks-bar").textContent))""")
    assert "(" in browser.evaluate("document.getElementById('view-rock-bar').textContent")
    choose(browser, "cracks", "")
    browser.evaluate("""(() => {
      const factor = document.getElementById("view-scale");
      factor.value = 0;
      factor.dispatchEvent(new Event("input"));
    })()""")
    seen.append(pixels(browser))
    browser.evaluate("document.getElementById('view-edges').click()")
    seen.append(pixels(browser))
    for one, other in zip(seen, seen[1:]):
        assert (one != other).any()
    assert browser.problems == []


MOMENT = "document.getElementById('view-moment').textContent"


def test_the_slider_goes_through_the_run_by_keys(browser, pages):
    opened(browser, pages["coupled"])
    last, bar = pixels(browser), browser.evaluate("document.querySelector('.bars').textContent")
    assert browser.evaluate(MOMENT) == "t = 5 ms"
    browser.evaluate("document.getElementById('view-time').focus()")
    browser.press("ArrowLeft")
    browser.wait_for(f"{MOMENT} === 't = 3.333 ms'")
    assert browser.evaluate("document.getElementById('view-time').ariaValueText") == "t = 3.333 ms"
    assert (pixels(browser) != last).any()
    browser.press("Home")
    browser.wait_for(f"{MOMENT} === 't = 0 ms'")
    # Colours mean the same at all times, until those of one time are asked for.
    assert browser.evaluate("document.querySelector('.bars').textContent") == bar
    assert tip_at(browser, 1.9, 0.9)[0].startswith("Pressure: ")
    browser.evaluate("document.getElementById('view-alone').click()")
    browser.evaluate("document.getElementById('view-alone').click()")
    browser.press("End")
    browser.evaluate("player.go(3)")
    assert (pixels(browser) == last).all()
    assert browser.problems == []
    assert [one for one in browser.requests if not one.startswith("data:")] == [pages["coupled"]]


def test_colours_of_one_time_alone(browser, pages):
    opened(browser, pages["mechanics"])
    browser.evaluate("choose('rock', 'principal_stress_2')")
    ends = [browser.evaluate("rangeOf(state.rock).ends")]
    browser.evaluate("document.getElementById('view-alone').click()")
    for number in range(browser.evaluate("about.frames.length")):
        browser.evaluate(f"player.go({number})")
        ends.append(browser.evaluate("rangeOf(state.rock).ends"))
    assert ends[0][0] == min(low for low, _ in ends)
    assert len({tuple(one) for one in ends}) > 1


def test_the_run_plays_to_its_end(browser, pages):
    opened(browser, pages["coupled"])
    button = "document.getElementById('view-play')"
    browser.evaluate("canvas.focus()")
    browser.press(",", ",")
    browser.wait_for(f"{MOMENT} === 't = 3.333 ms'")
    browser.press(" ", " ")
    browser.wait_for(f"{MOMENT} === 't = 5 ms'")
    browser.wait_for(f"{button}.textContent === 'Play'")
    browser.evaluate(f"{button}.click()")  # at the end it begins anew
    browser.wait_for(f"{MOMENT} === 't = 0 ms'")
    assert browser.evaluate(f"{button}.textContent") == "Pause"
    browser.wait_for(f"{MOMENT} === 't = 1.667 ms'")
    browser.evaluate(f"{button}.click()")
    assert browser.evaluate(f"{button}.textContent") == "Play"
    assert browser.problems == []


def test_keys_for_one_time_stop_the_playing_and_all_count(browser, pages):
    opened(browser, pages["coupled"])
    browser.evaluate("player.go(0)")
    live = "document.getElementById('view-moment').getAttribute('aria-live')"
    browser.evaluate("player.toggle()")
    assert browser.evaluate(live) == "off"
    browser.evaluate("""(() => {
      for (const key of [".", ".", "."]) canvas.dispatchEvent(new KeyboardEvent("keydown", { key }));
    })()""")
    browser.wait_for(f"{MOMENT} === 't = 5 ms'")
    assert browser.evaluate("player.timer") is None
    assert browser.evaluate("document.getElementById('view-play').textContent") == "Play"
    assert browser.evaluate(live) == "polite"


def test_what_the_browser_kept_over_a_reload_holds(browser, pages):
    browser.before_pages("""new MutationObserver(() => {
      const box = document.getElementById("view-alone");
      if (box) box.checked = true;
    }).observe(document, { childList: true, subtree: true });""")
    opened(browser, pages["coupled"])
    browser.wait_for("player !== null")
    assert browser.evaluate("document.getElementById('view-alone').checked")
    assert browser.evaluate("state.alone")


def test_a_time_that_cannot_be_unpacked_stops_the_playing(browser, pages):
    opened(browser, pages["coupled"])
    browser.evaluate("player.go(0)")
    browser.evaluate("""(() => {
      const key = about.frames[1].arrays.displacement;
      document.getElementById("array-" + key).textContent = "AAAA";
      player.toggle();
    })()""")
    browser.wait_for("!document.getElementById('view-note').hidden")
    note = browser.evaluate("document.getElementById('view-note').textContent")
    assert note.startswith("A part of the view cannot be shown: ")
    assert browser.evaluate("document.getElementById('view-play').textContent") == "Play"
    assert browser.evaluate(MOMENT) == "t = 0 ms" and browser.evaluate("wanted.frame") == 0
    assert browser.problems == []


def test_no_gap_is_drawn_between_pieces_that_have_flown_apart(browser, pages):
    opened(browser, pages["coupled"])
    widths = browser.evaluate("""(async () => {
      const arrays = await model.load(state.frame), corners = [];
      for (const far of [0, 100]) {
        const displacement = arrays.displacement.slice();
        displacement[2 * arrays.gaps[0]] += far;
        const numbers = arrays.gaps.slice(0, 3);
        model.leaveOutWide(numbers, arrays.gaps, { ...arrays, displacement });
        corners.push(new Set(numbers).size);
      }
      return corners;
    })()""")
    assert widths == [3, 1]


def test_an_open_crack_is_filled_and_outlined_on_both_faces(browser, pages):
    opened(browser, pages["coupled"])
    browser.evaluate("model.deform(2000); state.centre = [-0.9, 0]; state.zoom = 1000; redraw()")

    def middle_column() -> np.ndarray:
        seen = pixels(browser)
        width, height = browser.evaluate("[gl.drawingBufferWidth, gl.drawingBufferHeight]")
        return seen.reshape(height, width, 4)[:, width // 2, :3].astype(int)

    shown = middle_column()
    browser.evaluate("model.faces.count = 0")
    lines = np.flatnonzero((middle_column() != shown).any(axis=1))
    # The crack is almost 0.4 m wide here, and its outline no ribbon in its middle.
    gap = np.flatnonzero(np.diff(lines) > 300)
    assert len(gap) == 1 and len(lines) < 20
    inside = shown[lines[gap[0]] + 1:lines[gap[0] + 1]]
    assert np.ptp(inside, axis=0).max() <= 2 and (inside[0] < 250).any()


def test_a_deformed_place_tells_where_it_was(browser, pages):
    opened(browser, pages["mechanics"])
    factor = browser.evaluate("about.scale")
    assert factor > 1
    choose(browser, "rock", "displacement")
    # A corner in the middle of the side, and where it is shown.
    where = browser.evaluate("""(() => {
      const k = 2 * 900;
      const at = [0, 1].map((i) => model.places[k + i] + about.scale * model.displacement[k + i]);
      return [at[0] + about.origin[0], at[1] + about.origin[1], model.places[k] + about.origin[0],
              Math.hypot(model.displacement[k], model.displacement[k + 1])];
    })()""")
    name, place = tip_at(browser, where[0], where[1])[:2]
    value, unit = name.removeprefix("Displacement: ").split()
    assert float(value) * {"mm": 1e-3, "µm": 1e-6}[unit] == pytest.approx(where[3], rel=0.05)
    assert float(place.split()[2]) == pytest.approx(where[2], abs=1e-3)


def test_a_narrow_window(browser, pages):
    browser.resize(400, 800)
    opened(browser, pages["coupled"])
    assert browser.evaluate("document.documentElement.scrollWidth") <= 400
    assert (pixels(browser)[:, :3] < 250).any(axis=1).mean() > 0.1


def test_a_browser_without_webgl_says_so(browser, pages):
    browser.before_pages("HTMLCanvasElement.prototype.getContext = () => null;")
    browser.open(pages["flow"])
    browser.wait_for(READY)
    note = browser.evaluate("document.getElementById('view-note').innerText")
    assert note.startswith("The view cannot be shown here: this browser shows no WebGL 2.")
    assert browser.problems == []
