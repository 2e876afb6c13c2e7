package badlog.page.export

import badlog.page.dom.json
import badlog.page.dom.saveFile
import badlog.page.view.Scene
import badlog.viewer.draw.figure.Sheet
import kotlinx.browser.window
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import org.w3c.files.File
import org.w3c.files.FilePropertyBag
import kotlin.js.Promise

/**
 * Sends [text] with a picture of [parts] in the first way that works. It tries the system's own dialog, as on phones, then the clipboard,
 * and finally saves the picture as a file.
 */
internal fun sendMoment(scene: Scene, text: String, parts: List<(Sheet) -> Unit>) = pictureOf(scene, parts) { picture ->
    val name = fileNameOf(scene, "moment", ".png")
    val file = File(arrayOf<dynamic>(picture), name, FilePropertyBag(type = "image/png"))
    val message = json("files" to arrayOf(file), "text" to text)
    shared(message).then({}, { problem ->
        // A reader who closes the system's dialog wants nothing else.
        if (problem.asDynamic().name == "AbortError") return@then
        copied(picture, text).then({ scene.notice.say("Picture and text copied: paste them into a message.") }, {
            saveFile(picture, name)
            scene.notice.say("The picture was saved, because this browser does not let pages send it.")
        })
    })
}

private fun shared(message: dynamic): Promise<Unit> = try {
    val navigator = window.navigator.asDynamic()
    if (navigator.canShare(message) == true) navigator.share(message).unsafeCast<Promise<Unit>>() else Promise.reject(Error())
} catch (problem: Throwable) {
    // Pages on a disk, and most desktops, have no such dialog.
    Promise.reject(problem)
}

private fun copied(picture: Blob, text: String): Promise<Unit> = try {
    val content = json("image/png" to picture, "text/plain" to Blob(arrayOf(text), BlobPropertyBag("text/plain")))
    val newItem = js("(content) => new ClipboardItem(content)")
    window.navigator.asDynamic().clipboard.write(arrayOf(newItem(content))).unsafeCast<Promise<Unit>>()
} catch (problem: Throwable) {
    Promise.reject(problem)
}
