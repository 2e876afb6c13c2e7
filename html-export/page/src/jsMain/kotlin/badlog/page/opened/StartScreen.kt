package badlog.page.opened

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.asList
import org.w3c.files.File

/**
 * What a page without a log shows: how to open one.
 *
 * @param settings what can be changed on every page.
 * @param onFiles called with the files that a person chose.
 * @param onServer lists the logs of the page's server; null if it comes from none.
 * @param onSample opens the sample in this page; null if it has none.
 */
internal class StartScreen(settings: HTMLElement, onFiles: (List<File>) -> Unit, onServer: (() -> Unit)?, onSample: (() -> Unit)?) {
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
                addFilePicker("open-folder", Icon.FOLDER, "Open a folder…", isFolder = true, onFiles)
                onSample?.let { addButton("", "Try the sample", onClick = it).id = "try-sample" }
            }
        }
        add("p", "screen-text", READABLE)
    }

    private companion object {
        const val READABLE =
            "It reads bags of badlog, WPILOG (WPILib, AdvantageKit), logs of the Driver Station (.dslog with .dsevents), CSV, each " +
                "also gzipped, and pages of badlog."
    }
}

/** Adds a button that lets a person choose files, or a folder. */
internal fun HTMLElement.addFilePicker(id: String, icon: Icon, label: String, isFolder: Boolean, onFiles: (List<File>) -> Unit) {
    val input = add("input").unsafeCast<HTMLInputElement>()
    input.type = "file"
    input.multiple = true
    input.isHidden = true
    input.setAttribute("aria-label", label)
    if (isFolder) input.setAttribute("webkitdirectory", "")
    input.addEventListener("change", {
        // The browser's own list becomes empty with the value.
        val chosen = input.files?.asList().orEmpty().toList()
        input.value = ""
        onFiles(chosen)
    })
    addButton("", "", "") { input.click() }.apply {
        this.id = id
        appendChild(icon.draw())
        add("span", "", label)
        // Phones cannot choose folders.
        isHidden = isFolder && input.asDynamic().webkitdirectory == undefined
    }
}
