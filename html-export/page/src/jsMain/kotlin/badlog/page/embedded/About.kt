package badlog.page.embedded

import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.files.File

/**
 * The facts that the page holds about its embedded file.
 *
 * @property name the file's name.
 * @property isCompressed whether the file itself is a gzip stream, possibly a cut one.
 * @property inflatedBytes the number of bytes that can be inflated from the embedded file.
 * @property isCut whether part of that gzip stream is missing.
 * @property lineSums the CRC-32 of the bytes in each line of the embedded file.
 * @property version the version of badlog that made the page.
 * @property second the name of the log's second file; its bytes follow the first [firstBytes]. Null if the log is one file.
 * @property isServed whether the page comes from a web server on a robot; it then lists the robot's logs.
 * @property isOnWeb whether the page comes from a web site; it then opens logs from links and from other programs.
 * @property fileKey identifies this file in the browser's storage.
 */
internal class About(
    val name: String,
    val isCompressed: Boolean,
    val inflatedBytes: Double,
    val isCut: Boolean,
    val lineSums: Array<Int>,
    val version: String,
    val second: String?,
    val firstBytes: Int?,
    val isServed: Boolean = false,
    val isOnWeb: Boolean = false,
    val fileKey: String = "$name:$inflatedBytes",
) {
    companion object {
        /** Returns the facts about [files], opened on a page made by badlog [version] and stored under [fileKey]. */
        fun of(files: List<File>, version: String, fileKey: String): About = About(
            name = files[0].name,
            isCompressed = false,
            inflatedBytes = files.sumOf { it.size.toDouble() },
            isCut = false,
            lineSums = emptyArray(),
            version = version,
            second = files.getOrNull(1)?.name,
            firstBytes = files[0].size.toInt(),
            fileKey = fileKey,
        )

        /** Reads the facts from the page. Returns null if the page is incomplete. */
        fun find(): About? {
            val text = document.getElementById("about")?.textContent ?: return null
            val json = try {
                JSON.parse<dynamic>(text)
            } catch (_: Throwable) {
                return null
            }
            return About(
                name = json.name as? String ?: "recording",
                isCompressed = json.original == "gzip",
                inflatedBytes = (json.inflatedBytes as? Number)?.toDouble() ?: 0.0,
                isCut = json.cut == true,
                lineSums = json.crc32.unsafeCast<Array<Int>?>() ?: emptyArray(),
                version = json.version as? String ?: "",
                second = json.second as? String,
                firstBytes = json.firstBytes as? Int,
                isServed = json.network == "robot" && window.location.protocol != "file:",
                isOnWeb = json.network == "web" && window.location.protocol != "file:",
            )
        }
    }
}
