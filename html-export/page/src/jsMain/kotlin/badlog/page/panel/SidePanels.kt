package badlog.page.panel

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.page.dom.Icon
import badlog.page.dom.LocalStorage
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Frame
import badlog.page.view.Scene
import badlog.viewer.draw.swerve.DrivePicture
import badlog.viewer.input.KeyAction
import badlog.viewer.panel.Button
import badlog.viewer.panel.CursorLine
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.cursorPanel
import badlog.viewer.panel.modulesPanel
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.state.GraphChange
import badlog.viewer.text.unitText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * A panel at the side of the page, and the button that opens and closes it.
 *
 * @param key the key that opens and closes it.
 */
internal abstract class SidePanel(scene: Scene, id: String, title: String, name: String, key: String, icon: Icon, bodyClass: String) {
    protected val body: HTMLElement = element("div", bodyClass)
    protected val nodes: PartNodes = PartNodes(scene.palette, scene.store::send)

    val element: HTMLElement = element("aside", "cursor-panel $id-panel card") {
        this.id = id
        setAttribute("aria-label", name)
        add("header", "graph-head") {
            add("h2", "findings-title", title)
            add("div", "graph-tools") { addIconButton("", Icon.CLOSE, "Close the ${title.lowercase()} ($key)") { toggle() } }
        }
        appendChild(body)
    }

    /** The button that opens and closes the panel. */
    val button: HTMLElement = element("div", "${title.lowercase()}-button") {
        addIconButton("", icon, "$name ($key)") { toggle() }.id = className
    }

    /** Whether the panel is visible; only then it follows the cursor. */
    val isOpen: Boolean get() = !element.isHidden

    /** Opens or closes it. */
    abstract fun toggle()

    protected fun setOpen(isOpen: Boolean) {
        element.isHidden = !isOpen
        button.firstElementChild?.setAttribute("aria-expanded", isOpen.toString())
    }
}

/**
 * The values of many topics at the cursor, most recently changed first. The browser remembers whether it is open.
 *
 * @param shown the lines of the graphs on the screen.
 * @param all the lines that a search may find.
 * @param beforeOpening closes the other panel, which has the same place.
 */
internal class CursorPanel(
    private val scene: Scene,
    private val shown: () -> List<GraphSeries>,
    private val all: () -> List<GraphSeries>,
    private val beforeOpening: () -> Unit,
) : SidePanel(scene, "cursor-values", "Values", "Values at the cursor", "V", Icon.LIST, "cursor-panel-body") {
    private val frame = Frame(::update)
    private var query = Query("")
    private var lines = emptyList<CursorLine>()
    private var values = CursorValues(emptyList(), scene.xAxis)

    init {
        setOpen(LocalStorage[KEY] == "open")
        scene.cursor.onChange { if (!element.isHidden) frame.ask() }
    }

    override fun toggle() {
        if (!isOpen) beforeOpening()
        setOpen(!isOpen)
        refresh()
        LocalStorage[KEY] = if (isOpen) "open" else ""
    }

    /** Shows the topics that [query] matches; without a search, the topics in the graphs. */
    fun filter(query: Query) {
        this.query = query
        refresh()
    }

    /** Lists the current topics again. */
    fun refresh() {
        if (element.isHidden) return
        val pinned = scene.board.now.graphs.mapNotNullTo(HashSet()) { it.lines.singleOrNull() }
        val wanted = if (query.isEmpty) {
            shown()
        } else {
            all().filter { query.matches("${it.topic.name} ${unitText(it.unit)}", scene.traitsOf(it, query)) }
        }
        lines = wanted.distinctBy { it.topic.name to it.isDerived to it.name }.map { line ->
            val name = if (line.isDerived) line.name else line.topic.name
            // The name of a topic derived by an attribute may exist only in its graph.
            val pin = Button("Keep on the board", GraphChange.ToggleOwn(name), PartIcon.PIN, isOn = name in pinned)
                .takeIf { scene.board.lines[name] != null }
            CursorLine(name, line, pin)
        }
        values = CursorValues(lines.map { it.line }, scene.xAxis)
        frame.ask()
    }

    private fun update() {
        val x = scene.cursor.x.takeIf { scene.cursor.isPlaced }
        body.patch(nodes.of(cursorPanel(lines, values, x, x?.let(scene::xText).orEmpty())))
    }
}

/**
 * The modules of a swerve drive: their state at the cursor, and their errors in the visible range. It opens in place of the values at the
 * cursor.
 *
 * @param beforeOpening closes the other panel, which has the same place.
 */
internal class ModulesPanel(private val scene: Scene, private val beforeOpening: () -> Unit) :
    SidePanel(scene, "modules", "Modules", "Swerve modules", KeyAction.MODULES.shortcut, Icon.WHEELS, "cursor-panel-rows") {
    private var parts = emptyList<Part>()
    private val frame = Frame(::draw)

    /** The range of the listed errors; null if none are listed. */
    private var listed: Span? = null
    private var listing: Int? = null
    private val picture by lazy { scene.drive?.let { DrivePicture(it, it.errors) } }

    init {
        setOpen(false)
        button.isHidden = scene.drive == null
        scene.cursor.onChange(::ask)
        scene.range.onChange(::ask)
        // Observes the parent, because drawing sets the size of the canvas itself.
        ResizeObserver(::ask).observe(element)
    }

    override fun toggle() {
        if (scene.drive == null) return scene.notice.say(SwerveDrive.NONE)
        if (!isOpen) beforeOpening()
        setOpen(!isOpen)
        ask()
    }

    /** Draws the panel with the current colors. */
    fun repaint() = ask()

    private fun ask() {
        if (element.isHidden) return
        frame.ask()
        if (listed == scene.range.now) return
        // The errors need all visible samples, which is too slow while the range moves.
        listing?.let(window::clearTimeout)
        listing = window.setTimeout(::listErrors, if (listed == null) 0 else AFTER_MOVING)
    }

    private fun draw() = body.patch(nodes.of(parts))

    /** Lists the errors within the visible range. */
    private fun listErrors() {
        val drive = scene.drive ?: return
        val picture = picture ?: return
        val range = scene.range.now
        listed = range
        parts = modulesPanel(drive, drive.errors?.within(range).orEmpty(), scene::xText, picture) { pen, width, colors ->
            draw(pen, width, scene.range.now, scene.cursor.now, colors)
        }
        draw()
    }
}

private const val KEY = "values"

/** The milliseconds without movement of the range before its errors are listed. */
private const val AFTER_MOVING = 150
