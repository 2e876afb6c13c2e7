package badlog.lib

import java.io.File
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.file.StandardOpenOption

/** Brings the names of [folder]'s files to the disk: without this, a cut of power could take a new file's very name. */
internal fun syncFolder(folder: File) {
    try {
        FileChannel.open(folder.toPath(), StandardOpenOption.READ).use { it.force(true) }
    } catch (_: IOException) {
        // Not every system lets one open a folder; those that do not keep names safe by themselves.
    }
}
