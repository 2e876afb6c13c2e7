package badlog.spark.storage

import badlog.files.LogName
import badlog.files.firstPartOf
import badlog.files.wholeLogs
import badlog.season.lake.LogSource
import badlog.signals.match.NaturalOrder
import org.apache.hadoop.conf.Configuration
import org.apache.hadoop.fs.FileStatus
import org.apache.hadoop.fs.FileSystem
import org.apache.hadoop.fs.Path
import java.io.IOException
import java.io.Serializable
import java.nio.file.Files

/**
 * A log on any file system that Hadoop supports.
 *
 * @property files the addresses of its files, usually one; a log of the Driver Station may have two.
 */
internal class RemoteLog(val source: LogSource, val files: List<String>) : Serializable {
    /**
     * Copies its files into [folder] of this machine. Returns the first one.
     *
     * @throws IOException if they cannot be read.
     */
    fun fetch(folder: java.nio.file.Path, configuration: Configuration): java.nio.file.Path = files.map { address ->
        val path = Path(address)
        folder.resolve(path.name).also { copy ->
            withoutChecksums(path.getFileSystem(configuration)).open(path).use { Files.copy(it, copy) }
        }
    }.first()
}

/**
 * Returns the possible logs in [folder] and, if [isDeep], in its subfolders. They are in natural order, as `badlog lake` finds them on a
 * disk.
 *
 * @throws IOException if the folder cannot be listed.
 */
internal fun logsIn(folder: String, configuration: Configuration, isDeep: Boolean = true): List<RemoteLog> {
    val path = Path(folder)
    val system = withoutChecksums(path.getFileSystem(configuration))
    val top = system.makeQualified(path)
    val found = if (system.getFileStatus(top).isFile) listOf(system.getFileStatus(top)) else filesIn(system, top, isDeep)
    val seconds = found.mapNotNull { second -> firstPartOf(plainPath(second))?.let { it to second } }.toMap()
    return wholeLogs(found, ::plainPath).map { logOf(it, seconds[plainPath(it)], top) }
        .sortedWith(compareBy(NaturalOrder) { it.source.path })
}

private fun filesIn(system: FileSystem, folder: Path, isDeep: Boolean): List<FileStatus> {
    val found = ArrayList<FileStatus>()
    val open = ArrayDeque(listOf(folder))
    while (open.isNotEmpty()) {
        for (status in system.listStatus(open.removeFirst())) {
            val name = status.path.name
            if (isDeep && status.isDirectory && !name.startsWith(".") && name != "node_modules") open += status.path
            if (status.isFile && mayBeLog(name)) found += status
        }
    }
    return found
}

/** Returns whether [name] may be a log; nothing on a cluster can read a `.hoot`. */
private fun mayBeLog(name: String): Boolean =
    !name.startsWith(".") && LogName.of(name).mayBeLog && !name.endsWith(".tar.gz", ignoreCase = true) &&
        !name.endsWith(".hoot", ignoreCase = true)

private fun logOf(first: FileStatus, second: FileStatus?, top: Path): RemoteLog {
    val parts = listOfNotNull(first, second)
    val below = first.path.toUri().path.removePrefix(top.toUri().path.removeSuffix("/") + "/")
    val source = LogSource(
        addressOf(first.path),
        first.path.name,
        if (first.path == top) first.path.name else below,
        parts.sumOf { it.len },
        parts.maxOf { it.modificationTime },
    )
    return RemoteLog(source, parts.map { it.path.toString() })
}

/** Returns the address that identifies the file at [path] in a lake; for a disk, the plain path. */
internal fun addressOf(path: Path): String = if (path.toUri().scheme in DISK) path.toUri().path else path.toString()

private fun plainPath(status: FileStatus) = java.nio.file.Path.of(status.path.toUri().path)

private val DISK = setOf(null, "file")

private const val serialVersionUID = 1L
