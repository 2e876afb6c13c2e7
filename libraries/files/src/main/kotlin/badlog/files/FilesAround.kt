package badlog.files

import java.io.IOException
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.attribute.BasicFileAttributes

/**
 * Returns the files around [file] with names that are [wanted][isWanted].
 *
 * Searches the file's folder and its direct subfolders, then the sibling folders and their direct subfolders. Never looks through the
 * folders of the user's home folder. Follows no links, and skips hidden and build folders. Looks at no more than 5,000 files and folders,
 * the nearest first; unreadable ones are skipped.
 */
public fun filesAround(file: Path, isWanted: (String) -> Boolean): List<Path> =
    filesAround(file, Path.of(System.getProperty("user.home")).toAbsolutePath().normalize(), isWanted)

/** Returns the files around [file] with wanted names, for a user with the home folder [home]. */
internal fun filesAround(file: Path, home: Path, isWanted: (String) -> Boolean): List<Path> {
    val folder = file.toAbsolutePath().normalize().parent
    val look = Around(isWanted)
    // A home folder holds private things, and many systems ask before a program looks into its folders.
    look.into(folder, depth = if (folder == home) 1 else 2)
    // Beside a folder at the top of a disk lies everything.
    folder.parent?.takeIf { folder != home && it != home && it.parent != null }?.let { look.into(it, depth = 3, except = folder) }
    return look.found.filter { it != file.toAbsolutePath().normalize() }
}

private class Around(private val isWanted: (String) -> Boolean) {
    val found = ArrayList<Path>()
    private var seen = 0

    fun into(root: Path, depth: Int, except: Path? = null) {
        val visitor = object : SimpleFileVisitor<Path>() {
            override fun preVisitDirectory(folder: Path, attributes: BasicFileAttributes): FileVisitResult = when {
                folder == root -> FileVisitResult.CONTINUE
                folder == except || isPassedOver(folder) -> FileVisitResult.SKIP_SUBTREE
                else -> next()
            }

            override fun visitFile(path: Path, attributes: BasicFileAttributes): FileVisitResult {
                // Files in the folder above belong to other things.
                val isNear = except == null || path.parent != root
                val name = path.fileName.toString()
                if (isNear && attributes.isRegularFile && !name.startsWith(".") && isWanted(name)) found.add(path)
                return next()
            }

            override fun visitFileFailed(path: Path, e: IOException): FileVisitResult = next()

            override fun postVisitDirectory(folder: Path, e: IOException?): FileVisitResult = FileVisitResult.CONTINUE
        }
        try {
            Files.walkFileTree(root, emptySet(), depth, visitor)
        } catch (_: IOException) {
            // Nothing of it can be read.
        }
    }

    private fun next() = if (++seen < MAX_ENTRIES) FileVisitResult.CONTINUE else FileVisitResult.TERMINATE
}

private const val MAX_ENTRIES = 5000
