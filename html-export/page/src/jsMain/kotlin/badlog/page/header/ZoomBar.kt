package badlog.page.header

import badlog.page.dom.Icon
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isDisabled
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.input.PointerListener
import badlog.page.pen.CanvasPen
import badlog.page.view.Frame
import badlog.page.view.Scene
import badlog.page.view.SceneTarget
import badlog.page.view.findingText
import badlog.page.view.shortFindingText
import badlog.page.view.textNear
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.drawOverview
import badlog.viewer.input.KeyAction
import badlog.viewer.input.PlotPointer
import badlog.viewer.session.gesture.OverviewGestures
import badlog.viewer.session.link.PageAddress
import badlog.viewer.state.Action
import badlog.viewer.text.differenceText
import badlog.viewer.text.word
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement

/**
 * The bar with the visible range, the cursor's place and the events there, always on the screen.
 *
 * @param panelLinks links to parts of the page.
 * @param link copies a link to the current view.
 */
internal class ZoomBar(private val scene: Scene, panelLinks: List<HTMLElement>, link: HTMLElement) {
    private val overview = Overview(scene)
    private lateinit var range: HTMLElement
    private lateinit var width: HTMLElement
    private lateinit var cursor: HTMLElement
    private lateinit var clock: HTMLElement
    private lateinit var day: HTMLElement
    private lateinit var second: HTMLElement
    private lateinit var event: HTMLElement
    private lateinit var back: HTMLElement
    private lateinit var reset: HTMLElement

    val element: HTMLElement = element("div", "zoom-bar") {
        add("div", "zoom-row") {
            for (panelLink in panelLinks) appendChild(panelLink)
            add("div", "place") {
                add("div", "readout") {
                    cursor = add("a", "cursor-readout")
                    clock = add("output", "clock-readout")
                    day = add("output", "day-readout").apply { title = "Time of day" }
                    second = add("output", "second-readout")
                    event = add("output", "event-readout")
                }
                add("div", "range-readout") {
                    range = add("output", "range")
                    width = add("output", "range-width")
                }
            }
            add("div", "zoom-buttons") {
                appendChild(link)
                addIconButton("", Icon.MINUS, "Zoom out (−)") { press(KeyAction.ZOOM_OUT) }.id = "zoom-out"
                addIconButton("", Icon.PLUS, "Zoom in (+)") { press(KeyAction.ZOOM_IN) }.id = "zoom-in"
                back = addIconButton("", Icon.BACK, "Previous view (Backspace)") { press(KeyAction.PREVIOUS_VIEW) }
                back.id = "back"
                reset = addButton("", "Reset zoom", "Show everything (0)") { press(KeyAction.SHOW_ALL) }
                reset.id = "reset"
            }
        }
        appendChild(overview.element)
    }

    init {
        val frame = Frame(::update)
        scene.range.onChange { frame.ask() }
        scene.cursor.onChange { frame.ask() }
        update()
    }

    /** Redraws the bar with the current colors. */
    fun repaint() = overview.drawMarks()

    /** Links to the pinned cursor, because the pointer passes over other times on its way to the link. */
    private fun showLink(pinned: Double?) {
        cursor.title = if (pinned == null) "Click a graph to pin the cursor, and link to its time" else "Link to this time"
        val link = pinned?.let { PageAddress(it, finding = scene.visitedAt(it)).toText() }
        if (link == null) cursor.removeAttribute("href") else cursor.setAttribute("href", link)
    }

    private fun press(key: KeyAction) = scene.store.send(Action.Press(key))

    private fun update() {
        val now = scene.range.now
        val all = scene.xAxis.range
        range.showText(
            when {
                all == null -> "No samples"
                all.start == all.endInclusive -> scene.xText(all.start)
                else -> "${scene.xNumber(now.from)} – ${scene.xText(now.to)}"
            },
        )
        width.showText(if (all == null || all.start == all.endInclusive) "" else "Δ ${scene.xText(now.width)}")
        back.isDisabled = !scene.range.canGoBack
        reset.isDisabled = !scene.range.isZoomed
        val x = scene.cursor.x
        cursor.isHidden = !scene.cursor.isPlaced
        clock.isHidden = !scene.cursor.isPlaced
        day.isHidden = !scene.cursor.isPlaced
        second.isHidden = scene.cursor.now.second == null
        event.isHidden = true
        if (!scene.cursor.isPlaced) return
        cursor.showText(scene.xText(x))
        clock.showText(scene.clocks.matchAt(x).orEmpty())
        val time = scene.clocks.dayAt(x).orEmpty()
        day.showText(time)
        // Most screens have no room for the time of day beside the other times.
        clock.title = "Phase, and time since the robot was enabled" + if (time.isEmpty()) "" else "; time of day $time"
        showLink(scene.cursor.now.pinned)
        scene.cursor.now.second?.let { second.showText("B ${scene.xText(it)} · ${differenceText(x, it, scene.xAxis)}") }
        val findings = scene.newsAt(x)
        event.className = "event-readout" + if (findings.isEmpty()) "" else " is-${findings[0].severity.word}"
        if (findings.isNotEmpty()) {
            event.isHidden = false
            event.showText(shortFindingText(findings, x))
            event.title = findings.joinToString("\n") { "${it.severity.word} · ${it.rule}: ${it.textNear(x)}" }
            return
        }
        val last = scene.lastEventAt(x) ?: return
        event.isHidden = false
        event.showText("${scene.xNumber(last.x)}  ${last.text}")
        event.title = last.text
    }
}

/**
 * The whole recording as a strip, with its modes, events and findings, and the visible part. Dragging moves the visible part or one of its
 * edges, or selects a new part.
 */
internal class Overview(private val scene: Scene) {
    private lateinit var marks: HTMLCanvasElement
    private lateinit var visible: HTMLElement
    private lateinit var cursor: HTMLElement
    private lateinit var second: HTMLElement
    private val full = scene.range.full
    private val gestures = OverviewGestures(SceneTarget(scene))

    val element: HTMLElement = element("div", "overview") {
        setAttribute("aria-hidden", "true")
        marks = add("canvas", "overview-marks").unsafeCast<HTMLCanvasElement>()
        visible = add("div", "overview-visible")
        cursor = add("div", "overview-cursor")
        second = add("div", "overview-cursor is-second")
    }

    init {
        PointerListener(element, gestures, onHover = ::point)
        ResizeObserver { drawMarks() }.observe(element)
        scene.range.onChange { update() }
        scene.cursor.onChange { update() }
        update()
    }

    /** Draws the marks of the events and findings, in the current colors. */
    fun drawMarks() {
        val ratio = window.devicePixelRatio
        val width = element.clientWidth * ratio
        val height = element.clientHeight * ratio
        marks.width = width.toInt()
        marks.height = height.toInt()
        val context = marks.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
        val frame = PlotFrame(0.0, 0.0, width, height, full)
        CanvasPen(context).drawOverview(frame, scene.marks, scene.palette.colors)
    }

    private fun update() {
        val now = scene.range.now
        visible.style.left = percent(now.from)
        visible.style.width = "${now.width / full.width * 100}%"
        visible.classList.toggle("is-all", !scene.range.isZoomed)
        place(cursor, scene.cursor.now.x)
        place(second, scene.cursor.now.second)
    }

    private fun place(line: HTMLElement, x: Double?) {
        line.isHidden = x == null
        if (x != null) line.style.left = percent(x)
    }

    private fun percent(x: Double) = "${(x - full.from) / full.width * 100}%"

    /** Shows the effect of a drag, and the findings under the pointer. */
    private fun point(at: PlotPointer) {
        val x = gestures.placeAt(at)
        element.title = findingText(scene.findings.at(x, full.width * REACH), x)
        element.style.cursor = CURSORS[gestures.gripAt(at).ordinal]
    }

    private companion object {
        /** The mouse pointer over each handle. */
        val CURSORS = listOf("ew-resize", "ew-resize", "grab", "crosshair")

        /** The maximum distance between the pointer and the mark under it, as a fraction of the strip. */
        const val REACH = 0.005
    }
}
