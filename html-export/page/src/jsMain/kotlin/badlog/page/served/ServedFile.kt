package badlog.page.served

import badlog.page.dom.json
import badlog.page.dom.place
import org.w3c.files.File
import org.w3c.files.FilePropertyBag

/**
 * The place of a listed log on a server.
 *
 * @property address the address of the log.
 * @property size the size of the log when it was listed, in bytes.
 */
internal class ServedFile(val address: String, val size: Double)

/** The place of this file on a server; null for a file that is here. */
internal val File.served: ServedFile? get() = asDynamic().served.unsafeCast<ServedFile?>()

/**
 * Returns an empty file that represents [served] in lists. It is named [name] at [place], and was last written at [modified], in ms since
 * 1970.
 */
internal fun fileFor(served: ServedFile, name: String, place: String, modified: Double): File =
    File(emptyArray(), name, json("lastModified" to modified).unsafeCast<FilePropertyBag>()).also {
        it.place = place
        it.asDynamic().served = served
    }
