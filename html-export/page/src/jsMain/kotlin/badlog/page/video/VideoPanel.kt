package badlog.page.video

import badlog.core.analysis.Units
import badlog.page.dom.Icon
import badlog.page.dom.LocalStorage
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.fileInput
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.session.video.VIDEO_SPEEDS
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.session.video.VideoNote
import badlog.viewer.session.video.alignmentHint
import badlog.viewer.session.video.enabledStart
import badlog.viewer.session.video.videoNoteOf
import badlog.viewer.session.video.within
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLSelectElement
import org.w3c.dom.HTMLVideoElement
import org.w3c.dom.url.URL
import org.w3c.files.File

/**
 * A video of the match beside its data. A video that the reader opens stays on the reader's machine.
 *
 * @param fileKey identifies this log in the browser's storage.
 * @param beside the name of a video beside the page, as part of an address; null if there is none.
 */
internal class VideoPanel(private val scene: Scene, fileKey: String, beside: String?) {
    private val key = "video:$fileKey"
    private val video = element("video").unsafeCast<HTMLVideoElement>().apply {
        controls = true
        setAttribute("playsinline", "")
    }
    private val secondsOfX = Units.secondsIn(scene.xAxis.unit)
    private val sync = VideoSync(video, scene, secondsOfX ?: 1.0)
    private var name = ""

    /** The alignment from a link, until a video is opened. */
    private var linked: VideoAlignment? = null
    private lateinit var heading: HTMLElement
    private lateinit var hint: HTMLElement
    private lateinit var link: HTMLElement

    private val input = fileInput("video-file", "Video file", "video/*,.mkv") { it.firstOrNull()?.let(::open) }

    val element: HTMLElement = element("aside", "video card") {
        id = "video"
        setAttribute("aria-label", "Video")
        add("header", "graph-head") {
            heading = add("h2", "findings-title cut-name").add("bdi", "", "Video")
            add("div", "graph-tools") {
                addIconButton("", Icon.FOLDER, "Open a video") { input.click() }
                addIconButton("", Icon.CLOSE, "Close") { close() }.id = "close-video"
            }
        }
        appendChild(input)
        appendChild(video)
        add("div", "video-tools") {
            addIconButton("", Icon.BACK, "Previous frame (,)") { step(-1) }.id = "previous-frame"
            addIconButton("redo", Icon.BACK, "Next frame (.)") { step(1) }.id = "next-frame"
            add("select") {
                id = "video-speed"
                setAttribute("aria-label", "Speed")
                for (speed in VIDEO_SPEEDS) add("option", "", "$speed×").setAttribute("value", "$speed")
                val select = unsafeCast<HTMLSelectElement>()
                select.value = "1"
                addEventListener("change", { video.playbackRate = select.value.toDouble() })
            }
            addButton("", "Enabled here", "The robot is enabled in this frame") { alignEnabled() }.apply {
                id = "video-enabled"
                isHidden = scene.enabled.isEmpty()
            }
            link =
                addIconButton("", Icon.LINK, "Link video and cursor") {
                    toggleLink()
                }
            link.id = "video-link"
        }
        hint = add("p", "cursor-panel-hint") { setAttribute("role", "status") }
        isHidden = true
    }

    /** The button that opens a video, or shows and hides the panel; hidden if x is not a time. */
    val button: HTMLElement = element("div", "downloads") {
        addButton("", "") {
            if (name.isEmpty()) input.click() else element.isHidden = !element.isHidden
        }.apply {
            id = "video-button"
            appendChild(Icon.VIDEO.draw())
            add("span", "", "Video")
        }
        isHidden = secondsOfX == null
    }

    /** The alignment of the video with the log; null if there is no video, or it has not been aligned. */
    var alignment: VideoAlignment?
        get() = sync.alignment ?: linked
        set(value) {
            linked = value
            if (name.isEmpty() || value == null) return
            use(value)
            sync.follow()
        }

    init {
        video.addEventListener("error", { if (name.isNotEmpty()) fail() })
        // For some files, a browser plays only the sound.
        video.addEventListener("loadedmetadata", { if (video.videoWidth == 0) fail() })
        if (beside != null && secondsOfX != null) {
            show(beside.substringAfterLast('/'), beside.split('/').joinToString("/", transform = ::encodeURIComponent))
        }
    }

    /** Shows [file] if it is a video, or the reason why it cannot be shown. Returns whether it is a video. */
    fun open(file: File): Boolean {
        val isVideo = file.type.startsWith("video/") || file.name.endsWith(".mkv")
        if (isVideo) {
            if (secondsOfX == null) scene.notice.say(VideoAlignment.NO_TIME) else show(file.name, URL.createObjectURL(file))
        }
        return isVideo
    }

    /** Moves by [count] frames, backward if it is negative. */
    fun step(count: Int) {
        if (!element.isHidden) sync.step(count)
    }

    private fun show(name: String, address: String) {
        this.name = name
        URL.revokeObjectURL(video.src)
        heading.showText(name)
        element.isHidden = false
        use(linked ?: LocalStorage[key].orEmpty().lines().map(::videoNoteOf).find { it?.name == name }?.alignment)
        video.src = address
    }

    private fun close() {
        video.pause()
        element.isHidden = true
    }

    private fun fail() = hint.showText(
        "This browser cannot play $name" + (if (video.src.startsWith("blob:")) "" else ", or it is not beside this page") +
            ".",
    )

    private fun alignEnabled() {
        val x = enabledStart(scene.enabled.map { it.span }, scene.range.now)
        if (x == null) scene.notice.say(VideoAlignment.NEVER_ENABLED) else alignAt(x)
    }

    private fun toggleLink() {
        if (sync.alignment == null) {
            return if (scene.cursor.isPlaced) alignAt(scene.cursor.x) else scene.notice.say(VideoAlignment.NO_CURSOR)
        }
        use(null)
        remember()
    }

    private fun alignAt(x: Double) {
        sync.align(x)
        use(sync.alignment)
        remember()
    }

    private fun use(alignment: VideoAlignment?) {
        linked = null
        sync.alignment = alignment
        link.setAttribute("aria-pressed", (alignment != null).toString())
        hint.showText(if (alignment == null) alignmentHint(scene.enabled.isNotEmpty()) else "")
    }

    private fun remember() {
        LocalStorage[key] = VideoNote(name, sync.alignment).within(LocalStorage[key].orEmpty())
    }
}

private external fun encodeURIComponent(text: String): String
