package badlog.page.opened

import badlog.formats.READABLE_LOGS
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.fileInput
import badlog.page.dom.isHidden
import org.w3c.dom.HTMLElement
import org.w3c.files.File

/**
 * The screen of a page without a log, with the ways to open one.
 *
 * @param settings the settings that every page has.
 * @param onFiles called with the chosen files.
 * @param onFolder called with the chosen folder, if the page may look into it again.
 * @param onServer lists the logs of the page's server; null if the page has no server.
 * @param onSample opens the sample in this page; null if it has none.
 */
internal class StartScreen(
    settings: HTMLElement,
    onFiles: (List<File>) -> Unit,
    onFolder: (WatchedFolder) -> Unit,
    onServer: (() -> Unit)?,
    onSample: (() -> Unit)?,
) {
    val element: HTMLElement = element("div", "start") {
        add("header", "page-head") {
            add("h1", "", "badlog")
            appendChild(settings)
        }
        add("div", "start-drop card") {
            add("p", "screen-title", "Open a robot’s log to see what happened.")
            add(
                "p",
                "screen-text",
                "Drop logs or a folder here, or choose them. They stay on this device: this page sends nothing anywhere.",
            )
            add("div", "page-tools") {
                onServer?.let { addButton("", "Logs on this robot", onClick = it).id = "open-server" }
                addFilePicker("open-logs", Icon.OPEN, "Open logs…", isFolder = false, onFiles)
                addFilePicker("open-folder", Icon.FOLDER, "Open a folder…", isFolder = true, onFiles, onFolder)
                onSample?.let { addButton("", "Try the sample", onClick = it).id = "try-sample" }
            }
        }
        add("p", "screen-text", "It reads $READABLE_LOGS, gzipped too, and badlog pages.")
    }

    /** Asks [question] above everything else, with a button [label] that calls [onAccept]; does nothing while another question waits. */
    fun offer(question: String, label: String, onAccept: () -> Unit) {
        // The meaning of a click must not change while it is being made.
        if (element.querySelector(".start-offer") != null) return
        val offer = element("div", "start-offer card") {
            add("p", "screen-text", question)
            add("div", "page-tools") {
                addButton("", label, onClick = onAccept).id = "accept-offer"
                addButton("", "No") { parentElement?.remove() }
            }
        }
        element.insertBefore(offer, element.querySelector(".start-drop"))
    }
}

/**
 * Adds a button that lets a person choose files or a folder. The folder is passed to [onFolder] if the browser lets the page look into it
 * again.
 */
internal fun HTMLElement.addFilePicker(
    id: String,
    icon: Icon,
    label: String,
    isFolder: Boolean,
    onFiles: (List<File>) -> Unit,
    onFolder: ((WatchedFolder) -> Unit)? = null,
) {
    val input = fileInput("", label, onFiles = onFiles)
    input.multiple = true
    if (isFolder) input.setAttribute("webkitdirectory", "")
    appendChild(input)
    fun choose() {
        if (onFolder == null || !WatchedFolder.areThere) return input.click()
        WatchedFolder.choose().then(onFolder).catch { if (it.asDynamic().name != CHANGED_MIND) input.click() }
    }
    addButton("", "", "") { choose() }.apply {
        this.id = id
        appendChild(icon.draw())
        add("span", "", label)
        // Phones cannot choose folders.
        isHidden = isFolder && input.asDynamic().webkitdirectory == undefined
    }
}

/** The browser's name for closing the dialog without choosing. */
private const val CHANGED_MIND = "AbortError"
