package badlog.page

import java.nio.file.Path
import java.util.Base64

/** Drops files with these names and bytes on the page. */
internal fun OpenPage.drop(vararg files: Pair<String, ByteArray>) {
    script(
        """
        const data = new DataTransfer()
        for (const [name, base64] of arguments[0]) {
            data.items.add(new File([Uint8Array.from(atob(base64), c => c.charCodeAt(0))], name))
        }
        document.body.dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true}))
        """.trimIndent(),
        files.map { (name, bytes) -> listOf(name, Base64.getEncoder().encodeToString(bytes)) },
    )
}

/** Drops [folder] on the page, as a person does. */
internal fun OpenPage.drop(folder: Path) {
    val data = mapOf("items" to emptyList<Any>(), "files" to listOf("$folder"), "dragOperationsMask" to 1)
    for (type in listOf("dragEnter", "dragOver", "drop")) {
        driver.executeCdpCommand("Input.dispatchDragEvent", mapOf("type" to type, "x" to 300, "y" to 300, "data" to data))
    }
}

/** Presses the button [label] of the page's question. */
internal fun OpenPage.choose(label: String) {
    await("the choice $label") { label in texts(".notice button") }
    click(".notice button") { it.text == label }
}

/** Drops files with these names and bytes on the page, to compare them with its log. */
internal fun OpenPage.compare(vararg files: Pair<String, ByteArray>) {
    drop(*files)
    choose("Compare with this log")
}
