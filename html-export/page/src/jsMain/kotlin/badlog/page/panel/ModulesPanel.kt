package badlog.page.panel

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.pen.CanvasPen
import badlog.page.view.Frame
import badlog.page.view.Scene
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.swerve.DrivePicture
import badlog.viewer.input.Action
import badlog.viewer.shown.swerve.DriveErrors
import badlog.viewer.shown.swerve.ErrorSize
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.shown.swerve.worstModuleText
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import kotlin.math.round

/**
 * The modules of a swerve drive: what they do at the cursor, and how well they follow their targets in the visible range. It takes the
 * place of the values at the cursor.
 *
 * @param beforeOpening closes what is in its place.
 */
internal class ModulesPanel(private val scene: Scene, private val beforeOpening: () -> Unit) {
    private lateinit var worst: HTMLElement
    private lateinit var canvas: HTMLCanvasElement
    private lateinit var list: HTMLElement
    private val frame = Frame(::update)

    /** The numbers that [list] shows. */
    private var listed = emptyList<List<Double>?>()
    private val picture by lazy { scene.drive?.let { DrivePicture(it, it.errors) } }

    val element: HTMLElement = element("aside", "cursor-panel modules-panel card") {
        id = "modules"
        setAttribute("aria-label", "Swerve modules")
        add("header", "graph-head") {
            add("h2", "findings-title", "Modules")
            add("div", "graph-tools") { addIconButton("", Icon.CLOSE, "Close the modules (${Action.MODULES.shortcut})") { close() } }
        }
        add("div", "cursor-panel-rows") {
            worst = add("p", "modules-worst")
            canvas = add("canvas").unsafeCast<HTMLCanvasElement>()
            add("p", "cursor-panel-hint", SwerveDrive.ARROWS)
            list = add("div", "modules-errors")
            add("p", "cursor-panel-hint", DriveErrors.WHEN)
        }
        isHidden = true
    }

    /** Opens and closes it; hidden if the log has no modules. */
    val button: HTMLElement = element("div", "modules-button") {
        addIconButton("", Icon.WHEELS, "Swerve modules (${Action.MODULES.shortcut})") { toggle() }.apply {
            id = "modules-button"
            setAttribute("aria-expanded", "false")
        }
        isHidden = scene.drive == null
    }

    init {
        scene.cursor.onChange(::ask)
        scene.range.onChange(::ask)
    }

    /** Opens or closes it. */
    fun toggle() {
        if (scene.drive == null) return scene.notice.say(SwerveDrive.NONE)
        if (element.isHidden) beforeOpening()
        setOpen(element.isHidden)
        ask()
    }

    /** Closes it. */
    fun close() = setOpen(false)

    /** Draws it with the current colors. */
    fun repaint() = ask()

    private fun setOpen(isOpen: Boolean) {
        element.isHidden = !isOpen
        button.firstElementChild?.setAttribute("aria-expanded", isOpen.toString())
    }

    private fun ask() {
        if (!element.isHidden) frame.ask()
    }

    private fun update() {
        val drive = scene.drive ?: return
        val picture = picture ?: return
        val ratio = window.devicePixelRatio
        canvas.style.height = "${picture.height}px"
        canvas.width = round(canvas.clientWidth * ratio).toInt()
        canvas.height = round(picture.height * ratio).toInt()
        val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
        picture.draw(CanvasPen(context), canvas.width.toDouble(), scene.range.now, scene.cursor.now, scene.palette.colors)
        val errors = drive.errors?.within(scene.range.now)
        worst.showText(errors?.let(::worstModuleText) ?: SwerveDrive.NO_TARGETS)
        // A button that is rebuilt while the cursor moves cannot be pressed.
        val sizes = errors.orEmpty().flatMap { listOf(it.angle, it.speed) }.map { size -> size?.run { listOf(rms, largest, largestAt) } }
        if (sizes == listed) return
        listed = sizes
        list.textContent = ""
        errors.orEmpty().forEachIndexed { i, error ->
            list.add("div", "module-error") {
                add("span", "swatch line-${i % LINE_COLORS}")
                add("b", "", error.label)
                error.angle?.let { size(it) }
                error.speed?.let { size(it) }
            }
        }
    }

    private fun HTMLElement.size(size: ErrorSize) {
        add("span", "", size.rmsText)
        val at = scene.xText(size.largestAt)
        addButton("text-button", size.largestText, "Go to the largest error, at $at") { scene.goTo(size.largestAt) }
    }
}
