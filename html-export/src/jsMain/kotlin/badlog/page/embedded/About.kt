package badlog.page.embedded

import kotlinx.browser.document

/**
 * What the page knows about the file it carries.
 *
 * @property name the file's name.
 * @property isCompressed whether the file itself is a gzip stream, possibly a cut one.
 * @property inflatedBytes how many bytes can be inflated from what the page carries.
 * @property isCut whether something of that gzip stream is missing.
 * @property version the version of badlog that made the page.
 * @property second the name of the log's second file, whose bytes stand behind the first [firstBytes]; null where it is one file.
 */
internal class About(
    val name: String,
    val isCompressed: Boolean,
    val inflatedBytes: Double,
    val isCut: Boolean,
    val version: String,
    val second: String?,
    val firstBytes: Int?,
) {
    /** Tells this file from others, for what the browser remembers of it. */
    val fileKey: String get() = "$name:$inflatedBytes"

    companion object {
        /** Reads it from the page, or null when the page was cut before its end. */
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
                version = json.version as? String ?: "",
                second = json.second as? String,
                firstBytes = json.firstBytes as? Int,
            )
        }
    }
}
