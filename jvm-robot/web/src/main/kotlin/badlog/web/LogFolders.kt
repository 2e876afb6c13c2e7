package badlog.web

import java.io.File
import java.io.IOException
import java.net.URLDecoder
import java.nio.file.DirectoryIteratorException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.LinkOption.NOFOLLOW_LINKS
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import kotlin.io.path.name

/**
 * The logs that the server shows: those in some folders and in the folders below. Links, hidden names and files without the ending of a log
 * are not served.
 *
 * @param homes folders that also hold other files; only the bags directly in them are shown.
 */
internal class LogFolders(private val folders: List<File>, private val homes: List<File> = emptyList()) {
    /** The name of each folder in addresses. It stays the same once the folder was seen, so that addresses lead to the same logs. */
    private val names = HashMap<Path, String>()

    /** Returns the folders that exist now, by their names. Folders of logs may be created later, and sticks come and go. */
    @Synchronized
    private fun roots(): Map<String, Path> {
        // Two names of one folder, such as a stick's and its link, are one.
        val found = folders.mapNotNull { folder -> if (folder.isDirectory) realPath(folder) else null }.distinct()
        val homesWithBags = realHomes().filter { it !in found && hasBag(it) }
        return (found + homesWithBags).associateBy { folder -> names.getOrPut(folder) { freeName(folder) } }
    }

    private fun realHomes(): List<Path> = homes.mapNotNull { home -> if (home.isDirectory) realPath(home) else null }.distinct()

    private fun hasBag(home: Path): Boolean {
        var hasBag = false
        forEachIn(home) { path, attributes -> if (isBag(path, attributes)) hasBag = true }
        return hasBag
    }

    private fun freeName(folder: Path): String {
        val name = folder.fileName?.toString()?.takeIf(::isVisible) ?: "logs"
        var free = name
        var number = 1
        while (free in names.values) free = "$name-${++number}"
        return free
    }

    /** Returns the content of the folder at [address], which begins and ends with `/`. Null if it does not exist. */
    fun list(address: String): Listing? {
        if (address == "/") return Listing(roots().keys.toList(), emptyList())
        val folder = resolve(address.removeSuffix("/")) ?: return null
        if (attributesOf(folder)?.isDirectory != true) return null
        val showsOnlyBags = showsOnlyBags(folder)
        val folders = ArrayList<String>()
        val files = ArrayList<ListedFile>()
        forEachIn(folder) { path, attributes ->
            when {
                showsOnlyBags -> if (isBag(path, attributes)) files += ListedFile(path, attributes)
                attributes.isDirectory -> folders += path.name
                else -> files += ListedFile(path, attributes)
            }
        }
        return Listing(folders, files)
    }

    /** Returns the log at [address]; null if there is none. */
    fun log(address: String): ListedFile? {
        val path = resolve(address) ?: return null
        val attributes = attributesOf(path) ?: return null
        val isServed = if (showsOnlyBags(path.parent)) isBag(path, attributes) else isLog(path, attributes)
        return if (isServed) ListedFile(path, attributes) else null
    }

    /** Calls [action] with each log and each folder in [folder]; with none if it cannot be read. */
    private fun forEachIn(folder: Path, action: (Path, BasicFileAttributes) -> Unit) = try {
        Files.newDirectoryStream(folder).use { paths ->
            for (path in paths) {
                val attributes = attributesOf(path) ?: continue
                if (isVisible(path.name) && (attributes.isDirectory || isLog(path, attributes))) action(path, attributes)
            }
        }
    } catch (_: IOException) {
        // The folder is gone, such as on a removed stick.
    } catch (_: DirectoryIteratorException) {
        // The folder disappeared while it was read.
    }

    /** Returns the path that [address] names. All of its parts but the last must be folders. */
    private fun resolve(address: String): Path? {
        val names = address.removePrefix("/").split('/').map { decoded(it) ?: return null }
        if (!names.all(::isVisible)) return null
        var path = roots()[names[0]] ?: return null
        for ((i, name) in names.withIndex().drop(1)) {
            path = try {
                path.resolve(name)
            } catch (_: InvalidPathException) {
                return null
            }
            val attributes = attributesOf(path) ?: return null
            // A home shows only the bags directly in it, and no folder.
            if (attributes.isDirectory && showsOnlyBags(path.parent)) return null
            if (i < names.lastIndex && !attributes.isDirectory) return null
        }
        return path
    }

    // A home that is itself a folder of logs shows everything.
    private fun showsOnlyBags(folder: Path) = folder in realHomes() && folders.none { it.isDirectory && realPath(it) == folder }

    private companion object {
        val BAG = Regex("""(?is).+\.(bag|badbag)(\.gz)?""")

        /** The file name endings of logs that a laptop must convert before it can read them. */
        val CONVERTED = listOf(".wpilogxz", ".hoot")
        val LOG = Regex((readable() + CONVERTED).joinToString("|", "(?is).+(", ")(\\.gz)?") { Regex.escape(it) })

        fun readable(): List<String> =
            checkNotNull(LogFolders::class.java.getResourceAsStream("endings.txt")).use { it.readBytes().decodeToString().lines() }

        fun isLog(path: Path, attributes: BasicFileAttributes) = attributes.isRegularFile && LOG.matches(path.name)

        fun isBag(path: Path, attributes: BasicFileAttributes) = attributes.isRegularFile && BAG.matches(path.name)

        /** Returns whether [name] may name a file or a folder, and is not hidden. */
        fun isVisible(name: String) = name.isNotEmpty() && name[0] != '.' && name.none { it in "/\\:" || it < ' ' || it == '\uFFFD' }

        fun decoded(name: String): String? = try {
            URLDecoder.decode(name.replace("+", "%2B"), "UTF-8")
        } catch (_: IllegalArgumentException) {
            null
        }

        /** Returns the attributes of the regular file or folder at [path]. Null if there is none, or if it is a link. */
        fun attributesOf(path: Path): BasicFileAttributes? = try {
            Files.readAttributes(path, BasicFileAttributes::class.java, NOFOLLOW_LINKS).takeUnless { it.isSymbolicLink || it.isOther }
        } catch (_: IOException) {
            null
        }

        fun realPath(folder: File): Path? = try {
            folder.toPath().toRealPath()
        } catch (_: IOException) {
            null
        }
    }
}

/**
 * The folders to which badlog and WPILib log. They are on a USB stick or its link, in the home of a roboRIO or a Systemcore, and in a
 * simulation.
 */
internal val USUAL_FOLDERS =
    listOf("/U/logs", "/V/logs", "/u/logs", "/home/lvuser/logs", "/home/systemcore/logs", "/home/lvuser/log", "logs").map(::File)

/** The folders in which programs with the original badlog put their bags, beside other files. */
internal val USUAL_HOMES = listOf("/home/lvuser", "/media/sda1").map(::File)
