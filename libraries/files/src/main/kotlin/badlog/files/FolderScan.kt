package badlog.files

import java.io.IOException
import java.nio.file.FileVisitOption
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes
import java.util.EnumSet

/**
 * The result of scanning a folder.
 *
 * @property files the possible logs, in no particular order. A log of two files is included once, by its first file.
 * @property unreadable the folders that could not be read.
 */
public class FolderScan private constructor(public val files: List<LogFile>, public val unreadable: List<Path>) {
    public companion object {
        /** No robot's logs are nested deeper. */
        private const val MAX_DEPTH = 16

        /**
         * Scans [folder] and all folders in it, without reading a file. Follows links, but never enters a folder twice. Skips hidden files, build
         * folders, and packs of rules, since slices in a pack are not separate logs.
         *
         * @param checkpoint called for each file; may throw to cancel.
         * @throws IOException if [folder] itself cannot be read.
         */
        public fun of(folder: Path, checkpoint: () -> Unit = {}): FolderScan {
            val look = Look(folder, checkpoint)
            Files.walkFileTree(folder, EnumSet.of(FileVisitOption.FOLLOW_LINKS), MAX_DEPTH, look)
            return FolderScan(whole(look.files), look.unreadable)
        }
    }

    private class Look(private val root: Path, private val checkpoint: () -> Unit) : SimpleFileVisitor<Path>() {
        val files = ArrayList<LogFile>()
        val unreadable = ArrayList<Path>()
        private val seen = HashSet<Any>()

        override fun preVisitDirectory(folder: Path, attributes: BasicFileAttributes): FileVisitResult {
            val isNew = seen.add(attributes.fileKey() ?: folder.toRealPath())
            val isWanted = isNew && (folder == root || !isPassedOver(folder))
            return if (isWanted) FileVisitResult.CONTINUE else FileVisitResult.SKIP_SUBTREE
        }

        override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult {
            checkpoint()
            // Reading a pipe or a device may never end.
            if (attributes.isRegularFile && isNamedLikeLog(file.fileName.toString())) {
                files += LogFile(file, attributes.size(), attributes.lastModifiedTime().toMillis())
            }
            return FileVisitResult.CONTINUE
        }

        override fun visitFileFailed(file: Path, e: IOException): FileVisitResult {
            if (file == root) throw e
            // A loop of links, or something deleted in the meantime, is not worth mentioning.
            if (Files.isDirectory(file) && !Files.isReadable(file)) unreadable.add(file)
            return FileVisitResult.CONTINUE
        }

        override fun postVisitDirectory(folder: Path, e: IOException?): FileVisitResult = FileVisitResult.CONTINUE
    }
}

/** Returns these files without the second files of logs, which are added to the first ones. */
private fun whole(files: List<LogFile>): List<LogFile> {
    val seconds = files.associateBy { firstPartOf(it.path) }
    return wholeLogs(files, LogFile::path).map { file -> seconds[file.path]?.let(file::with) ?: file }
}

/** Returns whether [name] may belong to a log; the content decides later. A `.hoot` counts only if something can read it. */
private fun isNamedLikeLog(name: String): Boolean {
    val parts = LogName.of(name)
    return !name.startsWith(".") && parts.mayBeLog && !name.endsWith(".tar.gz", ignoreCase = true) &&
        (!parts.ending.equals(LogName.HOOT, ignoreCase = true) || Owlet.isInstalled)
}

/** The end of the name of a folder with a pack of rules. */
private const val PACK = ".badlog-rules"

/** Returns whether [folder] is skipped, because it is hidden, made by a build, or a pack of rules. */
internal fun isPassedOver(folder: Path): Boolean {
    val name = folder.fileName.toString()
    return name.startsWith(".") || name == "node_modules" || name == "\$RECYCLE.BIN" || name.endsWith(PACK, ignoreCase = true) ||
        (name == "build" && listOf("build.gradle", "build.gradle.kts").any { Files.exists(folder.resolveSibling(it)) })
}
