package badlog.spark.storage

import org.apache.hadoop.fs.FileContext
import org.apache.hadoop.fs.FileSystem
import org.apache.hadoop.fs.LocalFileSystem
import org.apache.hadoop.fs.Options
import org.apache.hadoop.fs.Path
import org.apache.hadoop.fs.RawLocalFileSystem
import org.apache.hadoop.fs.UnsupportedFileSystemException
import org.apache.spark.util.SerializableConfiguration
import java.io.FileNotFoundException
import java.io.IOException
import java.io.InputStream
import java.io.Serializable
import java.nio.file.Files
import java.util.UUID

/**
 * A folder on any file system that Hadoop supports, such as a disk, HDFS or an object store. Its functions throw an [IOException] if that
 * file system fails.
 *
 * @param address the address of the folder, as it was given to `spark-submit`.
 * @param draft the beginning of the names of unfinished files.
 */
internal class RemoteFolder(private val address: String, private val configuration: SerializableConfiguration, private val draft: String) :
    Serializable {
    private val top: Path get() = Path(address)

    /** Returns the path of [name] below this folder; slashes separate folders. */
    private fun path(name: String): Path = name.split('/').fold(top, ::Path)

    /** Returns whether there is a file or folder called [name]. */
    fun has(name: String): Boolean = system().exists(path(name))

    /** Returns the names of all files in this folder and its subfolders; none if it does not exist. */
    fun files(): Set<String> = names(top).toSet()

    /** Returns the names of the files and folders directly in this folder; none if it does not exist. */
    fun entries(): List<String> = try {
        system().listStatus(top).map { it.path.name }
    } catch (_: FileNotFoundException) {
        emptyList()
    }

    private fun names(folder: Path): List<String> = try {
        val root = system().makeQualified(top).toUri().path.removeSuffix("/")
        val all = system().listFiles(folder, true)
        buildList { while (all.hasNext()) add(all.next().path.toUri().path.removePrefix("$root/")) }
    } catch (_: FileNotFoundException) {
        emptyList()
    }

    /** Returns the text of the file [name]. */
    fun text(name: String): String = system().open(path(name)).use { it.readAllBytes().decodeToString() }

    /** Writes [text] to the file [name] atomically. */
    fun put(text: String, name: String): Unit = put(text.byteInputStream(), name)

    /** Copies [file] of this machine to [name] atomically, even if others do the same at the same time. */
    fun put(file: java.nio.file.Path, name: String): Unit = Files.newInputStream(file).use { put(it, name) }

    private fun put(bytes: InputStream, name: String) {
        val target = path(name)
        val unfinished = Path(target.parent, "$draft${UUID.randomUUID()}.part")
        val system = system()
        try {
            system.create(unfinished, true).use { bytes.copyTo(it, BUFFER) }
            replace(system, unfinished, target)
        } finally {
            system.delete(unfinished, false)
        }
    }

    private fun replace(system: FileSystem, from: Path, to: Path) {
        // On a disk, renaming replaces the target; other file systems need an option for that, and some lack it.
        val isDone = system is RawLocalFileSystem && system.rename(from, to)
        if (isDone) return
        try {
            FileContext.getFileContext(system.makeQualified(to).toUri(), configuration.value()).rename(from, to, Options.Rename.OVERWRITE)
        } catch (_: UnsupportedFileSystemException) {
            system.delete(to, false)
            if (!system.rename(from, to)) throw IOException("$from could not be renamed to $to.")
        }
    }

    /** Copies the file [name] to [file] of this machine, if it exists. */
    fun fetch(name: String, file: java.nio.file.Path) {
        val source = path(name)
        if (!system().exists(source)) return
        Files.createDirectories(file.parent)
        system().open(source).use { Files.copy(it, file) }
    }

    /** Deletes the file [name], if it exists. */
    fun delete(name: String) {
        system().delete(path(name), false)
    }

    /** Returns the file system; for a disk, the one that writes no checksum files. */
    private fun system(): FileSystem = withoutChecksums(top.getFileSystem(configuration.value()))
}

/** Returns [system]; for a disk, the one that writes no checksum files. */
internal fun withoutChecksums(system: FileSystem): FileSystem = if (system is LocalFileSystem) system.raw else system

private const val serialVersionUID = 1L
private const val BUFFER = 1 shl 17
