package badlog.page

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.readBytes

/** Returns the file [name] that the browser saves during [work]. */
internal fun OpenPage.saved(name: String, work: () -> Unit): ByteArray {
    val file = Chromium.downloads.resolve(name)
    file.deleteIfExists()
    work()
    await("the download $name") { file.exists() && !Path.of("$file.crdownload").exists() }
    return file.readBytes().also { Files.delete(file) }
}

/** Opens the menu of the button that matches [opener], and selects [entry]. */
internal fun OpenPage.selectIn(opener: String, entry: String) {
    script("document.querySelector(arguments[0]).click()", opener)
    val clicked = script(
        "const item = [...document.querySelectorAll('.menu button')].find(b => b.textContent === arguments[0]); item?.click(); return !!item",
        entry,
    )
    check(clicked == true) { "No entry “$entry” among ${texts(".menu button")}" }
    settle()
}

/** Returns the file [name] that the [entry] of the Export menu saves. */
internal fun OpenPage.exported(entry: String, name: String): ByteArray = saved(name) { selectIn("#export", entry) }
