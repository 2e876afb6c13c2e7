package badlog.page.panel

import badlog.core.analysis.Span
import badlog.page.dom.Icon
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
import badlog.viewer.panel.Part
import badlog.viewer.panel.modulesPanel
import badlog.viewer.shown.swerve.SwerveDrive
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * The modules of a swerve drive: their state at the cursor, and their errors in the visible range. It opens in place of the values at the
 * cursor.
 *
 * @param beforeOpening closes the other panel, which has the same place.
 */
internal class ModulesPanel(private val scene: Scene, private val beforeOpening: () -> Unit) {
    private lateinit var body: HTMLElement
    private val nodes = PartNodes(scene.palette, scene.store::send)
    private var parts = emptyList<Part>()
    private val frame = Frame(::draw)

    /** The range of the listed errors; null if none are listed. */
    private var listed: Span? = null
    private var listing: Int? = null
    private val picture by lazy { scene.drive?.let { DrivePicture(it, it.errors) } }

    val element: HTMLElement = element("aside", "cursor-panel modules-panel card") {
        id = "modules"
        setAttribute("aria-label", "Swerve modules")
        add("header", "graph-head") {
            add("h2", "findings-title", "Modules")
            add("div", "graph-tools") { addIconButton("", Icon.CLOSE, "Close the modules (${KeyAction.MODULES.shortcut})") { close() } }
        }
        body = add("div", "cursor-panel-rows")
        isHidden = true
    }

    /** The button that opens and closes the panel; hidden if the log has no modules. */
    val button: HTMLElement = element("div", "modules-button") {
        addIconButton("", Icon.WHEELS, "Swerve modules (${KeyAction.MODULES.shortcut})") { toggle() }.apply {
            id = "modules-button"
            setAttribute("aria-expanded", "false")
        }
        isHidden = scene.drive == null
    }

    init {
        scene.cursor.onChange(::ask)
        scene.range.onChange(::ask)
        // Observes the parent, because drawing sets the size of the canvas itself.
        ResizeObserver(::ask).observe(element)
    }

    val isOpen: Boolean get() = !element.isHidden

    /** Opens or closes the panel. */
    fun toggle() {
        if (scene.drive == null) return scene.notice.say(SwerveDrive.NONE)
        if (element.isHidden) beforeOpening()
        setOpen(element.isHidden)
        ask()
    }

    fun close() = setOpen(false)

    /** Draws the panel with the current colors. */
    fun repaint() = ask()

    private fun setOpen(isOpen: Boolean) {
        element.isHidden = !isOpen
        button.firstElementChild?.setAttribute("aria-expanded", isOpen.toString())
    }

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

    private companion object {
        /** The milliseconds without movement of the range before its errors are listed. */
        const val AFTER_MOVING = 150
    }
}
