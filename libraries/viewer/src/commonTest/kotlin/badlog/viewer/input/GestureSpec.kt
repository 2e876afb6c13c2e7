package badlog.viewer.input

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.filter
import io.kotest.property.checkAll

class GestureSpec : FunSpec({
    val whole = Viewport(Span(0.0, 100.0))
    val zoomed = whole.showing(40.0, 60.0)

    test("each key has one effect, whether or not a keyboard needs Shift for its character") {
        KeyAction.entries.flatMap { it.keys.toList() }.shouldBeUnique()
        KeyAction.of("N", shift = false) shouldBe KeyAction.NEXT_FINDING
        KeyAction.of("N", shift = true) shouldBe KeyAction.PREVIOUS_FINDING
        KeyAction.of("+", shift = true) shouldBe KeyAction.ZOOM_IN
        KeyAction.of("+", shift = false) shouldBe KeyAction.ZOOM_IN
        KeyAction.of("E", shift = true).shouldBeNull()
        KeyAction.of("Q", shift = false).shouldBeNull()
    }

    test("the help has every key, with Shift where it is needed") {
        KeyAction.NEXT_VIEW.help shouldBe HelpLine("Graphs", "Shift+Backspace", "Next view")
        KeyAction.SHOW_ALL.help.how shouldBe "0  Home"
        KeyAction.entries.map { it.meaning }.shouldBeUnique()
    }

    test("keys outside the graphs differ from those of the graphs, and from each other") {
        val others = ScreenKey.entries.map { it.onPage.text }
        (others + KeyAction.entries.flatMap { action -> action.keys.map { it.text } }).shouldBeUnique()
        ScreenKey.onPage("?", shift = true, alt = false) shouldBe ScreenKey.HELP
        ScreenKey.onPage("Page up", shift = false, alt = true) shouldBe ScreenKey.PREVIOUS_LOG
        ScreenKey.onPage("Page up", shift = false, alt = false).shouldBeNull()
        ScreenKey.NEXT_LOG.helpOnPage.how shouldBe "Alt+Page down"
    }

    test("a drag zooms, pans with Shift, and zooms y with Alt") {
        DragKind.of(shift = false, alt = false) shouldBe DragKind.ZOOM
        DragKind.of(shift = true, alt = false) shouldBe DragKind.PAN
        DragKind.of(shift = false, alt = true) shouldBe DragKind.ZOOM_Y
    }

    test("the wheel alone scrolls, and pans sideways only in a zoomed graph") {
        Wheel().turned(zoomed, 0.0, 40.0, ctrl = false, shift = false, 50.0, 800.0, 0.0).shouldBeNull()
        Wheel().turned(whole, 40.0, 0.0, ctrl = false, shift = false, 50.0, 800.0, 0.0).shouldBeNull()
        Wheel().turned(zoomed, 80.0, 0.0, ctrl = false, shift = false, 50.0, 800.0, 0.0)?.visible shouldBe Span(42.0, 62.0)
        Wheel().turned(zoomed, 0.0, 80.0, ctrl = false, shift = true, 50.0, 800.0, 0.0)?.visible shouldBe Span(42.0, 62.0)
    }

    test("the wheel with Ctrl zooms, and keeps the point below the pointer in place") {
        checkAll(Arb.double(-200.0, 200.0).filter { it.isFinite() }, Arb.double(41.0, 59.0).filter { it.isFinite() }) { turn, x ->
            val after = Wheel().turned(zoomed, 0.0, turn, ctrl = true, shift = false, x, 800.0, 0.0).shouldNotBeNull().visible
            if (turn < 0) (after.width <= 20.0) shouldBe true
            if (after.from > 0 && after.to < 100) (x - after.from) / after.width shouldBe ((x - 40) / 20 plusOrMinus 1e-9)
        }
    }

    test("turns of the wheel in quick succession are one step back") {
        val wheel = Wheel()
        var seen = whole
        for (turn in 0..3) seen = wheel.turned(seen, 0.0, -40.0, ctrl = true, shift = false, 50.0, 800.0, turn * 100.0).shouldNotBeNull()
        seen.back().visible shouldBe whole.visible
        seen = wheel.turned(seen, 0.0, -40.0, ctrl = true, shift = false, 50.0, 800.0, 5000.0).shouldNotBeNull()
        seen.back().isZoomed shouldBe true
    }

    test("a key has another meaning with Ctrl or Alt") {
        KeyAction.of("Z", shift = false, ctrl = true) shouldBe KeyAction.UNDO
        KeyAction.of("Z", shift = true, ctrl = true) shouldBe KeyAction.REDO
        KeyAction.of("Z", shift = false) shouldBe null
        KeyAction.of("↑", shift = false, alt = true) shouldBe KeyAction.MOVE_UP
        KeyAction.of("N", shift = false, ctrl = true) shouldBe null
        KeyAction.REDO.help.how shouldBe "Ctrl+Shift+Z  Ctrl+Y"
    }

    test("two quick clicks at one place are a double click, and a third begins a new one") {
        val clicks = DoubleClick()
        clicks.isSecond(10.0, 0.0) shouldBe false
        clicks.isSecond(12.0, 200.0) shouldBe true
        clicks.isSecond(12.0, 300.0) shouldBe false
        clicks.isSecond(100.0, 400.0) shouldBe false
        clicks.isSecond(100.0, 4000.0) shouldBe false
    }

    test("a drag on the overview can begin at the edges of the visible range, inside it, and beside it") {
        OverviewGrip.at(40.5, zoomed, 0.2) shouldBe OverviewGrip.LEFT
        OverviewGrip.at(60.5, zoomed, 0.2) shouldBe OverviewGrip.RIGHT
        OverviewGrip.at(50.0, zoomed, 0.2) shouldBe OverviewGrip.WINDOW
        OverviewGrip.at(80.0, zoomed, 0.2) shouldBe OverviewGrip.NEW
        OverviewGrip.at(50.0, whole, 0.2) shouldBe OverviewGrip.NEW
        OverviewGrip.at(50.0, whole.showing(49.9, 50.1), 1.0) shouldBe OverviewGrip.WINDOW
    }
})
