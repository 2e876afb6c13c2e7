package badlog.viewer.files

import java.nio.file.Path

/** Asks the person for a place in the file system. Each answer is null when the person has thought better of it. */
internal interface FileChoice {
    /** A file to write, called [name] if the person likes, in [folder] to begin with; overwriting was agreed to. */
    fun toWrite(title: String, folder: Path?, name: String): Path?

    /** A file to read whose name ends in [ending], empty for any, in [folder] to begin with. */
    fun toRead(title: String, folder: Path?, ending: String = ""): Path?

    /** A folder, [folder] to begin with. */
    fun folder(title: String, folder: Path?): Path?
}
