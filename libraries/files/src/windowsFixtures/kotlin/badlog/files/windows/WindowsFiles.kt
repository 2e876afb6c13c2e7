package badlog.files.windows

import com.google.common.jimfs.Configuration
import com.google.common.jimfs.Jimfs
import java.io.FilterOutputStream
import java.io.OutputStream
import java.net.URI
import java.nio.channels.FileChannel
import java.nio.channels.SeekableByteChannel
import java.nio.file.AccessDeniedException
import java.nio.file.AccessMode
import java.nio.file.CopyOption
import java.nio.file.DirectoryStream
import java.nio.file.FileStore
import java.nio.file.FileSystem
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.LinkOption
import java.nio.file.OpenOption
import java.nio.file.Path
import java.nio.file.StandardCopyOption
import java.nio.file.StandardOpenOption
import java.nio.file.attribute.BasicFileAttributes
import java.nio.file.attribute.FileAttribute
import java.nio.file.attribute.FileAttributeView
import java.nio.file.spi.FileSystemProvider

/**
 * A file system in memory that behaves as Windows does. Names and paths are jimfs' own work: drives, backslashes, refused characters and
 * ends of names. This adds what jimfs leaves out: a file that is read-only, or that a program has open, can be neither replaced nor deleted.
 */
internal class WindowsFiles : AutoCloseable {
    private val inner = Jimfs.newFileSystem(Configuration.windows().toBuilder().setAttributeViews("basic", "dos").build())
    private val provider = Provider(inner.provider())
    private val system = System(inner, provider)

    /** The files that are open, and how often. */
    private val open = HashMap<Path, Int>()

    /** The folder in which everything happens. */
    val folder: Path = path("C:\\Users\\Jürgen Müller\\logs").also { Files.createDirectories(it) }

    fun path(text: String): Path = Wrapped(inner.getPath(text))

    /** Makes [file] read-only. */
    fun protect(file: Path) {
        Files.setAttribute(unwrapped(file), "dos:readonly", true)
    }

    /** Does [work] while another program has [file] open. */
    fun <T> whileOpen(file: Path, work: () -> T): T {
        opened(unwrapped(file))
        try {
            return work()
        } finally {
            closed(unwrapped(file))
        }
    }

    /** The number of files that are open. */
    val openCount: Int get() = open.size

    override fun close() = inner.close()

    private fun opened(file: Path) = open.merge(file.toAbsolutePath().normalize(), 1, Int::plus)

    private fun closed(file: Path) = open.computeIfPresent(file.toAbsolutePath().normalize()) { _, count -> (count - 1).takeIf { it > 0 } }

    private fun requireFree(file: Path, other: Path?) {
        if (!Files.exists(file)) return
        if (Files.getAttribute(file, "dos:readonly") == true) throw AccessDeniedException("$file")
        if (file.toAbsolutePath().normalize() in open) {
            throw FileSystemException(
                "$file",
                other?.toString(),
                "The process cannot access the file because it is being used by another process",
            )
        }
    }

    private fun unwrapped(path: Path) = (path as Wrapped).inner

    /** A path in the file system [system]. */
    private inner class Wrapped(val inner: Path) : Path by inner {
        private fun of(path: Path?) = path?.let(::Wrapped)

        override fun getFileSystem(): FileSystem = system

        override fun getRoot(): Path? = of(inner.root)

        override fun getFileName(): Path? = of(inner.fileName)

        override fun getParent(): Path? = of(inner.parent)

        override fun getName(index: Int): Path = Wrapped(inner.getName(index))

        override fun subpath(from: Int, until: Int): Path = Wrapped(inner.subpath(from, until))

        override fun startsWith(other: Path): Boolean = inner.startsWith(unwrapped(other))

        override fun endsWith(other: Path): Boolean = inner.endsWith(unwrapped(other))

        override fun normalize(): Path = Wrapped(inner.normalize())

        override fun resolve(other: Path): Path = Wrapped(inner.resolve(unwrapped(other)))

        override fun resolve(other: String): Path = Wrapped(inner.resolve(other))

        override fun resolveSibling(other: String): Path = Wrapped(inner.resolveSibling(other))

        override fun relativize(other: Path): Path = Wrapped(inner.relativize(unwrapped(other)))

        override fun toAbsolutePath(): Path = Wrapped(inner.toAbsolutePath())

        override fun toRealPath(vararg options: LinkOption): Path = Wrapped(inner.toRealPath(*options))

        override fun iterator(): MutableIterator<Path> = inner.map { Wrapped(it) as Path }.toMutableList().iterator()

        override fun compareTo(other: Path): Int = inner.compareTo(unwrapped(other))

        override fun equals(other: Any?): Boolean = other is Wrapped && other.inner == inner

        override fun hashCode(): Int = inner.hashCode()

        override fun toString(): String = inner.toString()
    }

    private inner class System(private val inner: FileSystem, private val provider: Provider) : FileSystem() {
        override fun provider() = provider

        override fun close() = inner.close()

        override fun isOpen() = inner.isOpen

        override fun isReadOnly() = inner.isReadOnly

        override fun getSeparator(): String = inner.separator

        override fun getRootDirectories() = inner.rootDirectories.map { Wrapped(it) }

        override fun getFileStores(): Iterable<FileStore> = inner.fileStores

        override fun supportedFileAttributeViews(): Set<String> = inner.supportedFileAttributeViews()

        override fun getPath(first: String, vararg more: String) = Wrapped(inner.getPath(first, *more))

        override fun getPathMatcher(pattern: String) = inner.getPathMatcher(pattern).let { matcher ->
            java.nio.file.PathMatcher { matcher.matches(unwrapped(it)) }
        }

        override fun getUserPrincipalLookupService() = throw UnsupportedOperationException()

        override fun newWatchService() = throw UnsupportedOperationException()
    }

    private inner class Provider(private val inner: FileSystemProvider) : FileSystemProvider() {
        override fun move(from: Path, to: Path, vararg options: CopyOption) {
            requireFree(unwrapped(from), unwrapped(to))
            requireFree(unwrapped(to), unwrapped(from))
            // An atomic move replaces on Windows, too (MoveFileEx); in jimfs only if that is asked for.
            val replacing = if (StandardCopyOption.ATOMIC_MOVE in options) arrayOf(StandardCopyOption.REPLACE_EXISTING) else emptyArray()
            inner.move(unwrapped(from), unwrapped(to), *options, *replacing)
        }

        override fun copy(from: Path, to: Path, vararg options: CopyOption) {
            requireFree(unwrapped(to), unwrapped(from))
            inner.copy(unwrapped(from), unwrapped(to), *options)
        }

        override fun delete(file: Path) {
            requireFree(unwrapped(file), null)
            inner.delete(unwrapped(file))
        }

        override fun newOutputStream(file: Path, vararg options: OpenOption): OutputStream {
            requireWritable(unwrapped(file))
            val out = inner.newOutputStream(unwrapped(file), *options)
            opened(unwrapped(file))
            var isOpen = true
            return object : FilterOutputStream(out) {
                override fun write(bytes: ByteArray, from: Int, size: Int) = out.write(bytes, from, size)

                override fun close() {
                    super.close()
                    if (isOpen) closed(unwrapped(file))
                    isOpen = false
                }
            }
        }

        override fun newFileChannel(file: Path, options: Set<OpenOption>, vararg attributes: FileAttribute<*>): FileChannel {
            if (StandardOpenOption.WRITE in options) requireWritable(unwrapped(file))
            val channel = inner.newFileChannel(unwrapped(file), options, *attributes)
            opened(unwrapped(file))
            return WindowsChannel(channel) { closed(unwrapped(file)) }
        }

        override fun newByteChannel(file: Path, options: Set<OpenOption>, vararg attributes: FileAttribute<*>): SeekableByteChannel =
            inner.newByteChannel(unwrapped(file), options, *attributes)

        private fun requireWritable(file: Path) {
            if (Files.exists(file) && Files.getAttribute(file, "dos:readonly") == true) throw AccessDeniedException("$file")
        }

        override fun newDirectoryStream(folder: Path, filter: DirectoryStream.Filter<in Path>): DirectoryStream<Path> {
            val all = inner.newDirectoryStream(unwrapped(folder)) { true }
            return object : DirectoryStream<Path> {
                override fun iterator() = all.map { Wrapped(it) as Path }.filter(filter::accept).toMutableList().iterator()

                override fun close() = all.close()
            }
        }

        override fun createDirectory(folder: Path, vararg attributes: FileAttribute<*>) =
            inner.createDirectory(unwrapped(folder), *attributes)

        override fun isSameFile(one: Path, other: Path) = inner.isSameFile(unwrapped(one), unwrapped(other))

        override fun isHidden(file: Path) = inner.isHidden(unwrapped(file))

        override fun getFileStore(file: Path): FileStore = inner.getFileStore(unwrapped(file))

        override fun checkAccess(file: Path, vararg modes: AccessMode) {
            inner.checkAccess(unwrapped(file), *modes)
            if (AccessMode.WRITE in modes) requireWritable(unwrapped(file))
        }

        override fun <V : FileAttributeView> getFileAttributeView(file: Path, type: Class<V>, vararg options: LinkOption): V? =
            inner.getFileAttributeView(unwrapped(file), type, *options)

        override fun <A : BasicFileAttributes> readAttributes(file: Path, type: Class<A>, vararg options: LinkOption): A =
            inner.readAttributes(unwrapped(file), type, *options)

        override fun readAttributes(file: Path, names: String, vararg options: LinkOption): Map<String, Any> =
            inner.readAttributes(unwrapped(file), names, *options)

        override fun setAttribute(file: Path, name: String, value: Any?, vararg options: LinkOption) =
            inner.setAttribute(unwrapped(file), name, value, *options)

        override fun getScheme() = "windows"

        override fun newFileSystem(uri: URI, environment: Map<String, *>) = throw UnsupportedOperationException()

        override fun getFileSystem(uri: URI) = system

        override fun getPath(uri: URI) = throw UnsupportedOperationException()
    }
}
