package badlog.files.windows

import java.nio.ByteBuffer
import java.nio.MappedByteBuffer
import java.nio.channels.FileChannel
import java.nio.channels.FileLock
import java.nio.channels.ReadableByteChannel
import java.nio.channels.WritableByteChannel

/** The channel [inner], which says when it is closed. */
internal class WindowsChannel(private val inner: FileChannel, private val closed: () -> Unit) : FileChannel() {
    override fun read(bytes: ByteBuffer): Int = inner.read(bytes)

    override fun read(bytes: Array<ByteBuffer>, from: Int, count: Int): Long = inner.read(bytes, from, count)

    override fun read(bytes: ByteBuffer, position: Long): Int = inner.read(bytes, position)

    override fun write(bytes: ByteBuffer): Int = inner.write(bytes)

    override fun write(bytes: Array<ByteBuffer>, from: Int, count: Int): Long = inner.write(bytes, from, count)

    override fun write(bytes: ByteBuffer, position: Long): Int = inner.write(bytes, position)

    override fun position(): Long = inner.position()

    override fun position(position: Long): FileChannel = apply { inner.position(position) }

    override fun size(): Long = inner.size()

    override fun truncate(size: Long): FileChannel = apply { inner.truncate(size) }

    override fun force(withMetadata: Boolean) = inner.force(withMetadata)

    override fun transferTo(position: Long, count: Long, target: WritableByteChannel): Long = inner.transferTo(position, count, target)

    override fun transferFrom(source: ReadableByteChannel, position: Long, count: Long): Long = inner.transferFrom(source, position, count)

    override fun map(mode: MapMode, position: Long, size: Long): MappedByteBuffer = inner.map(mode, position, size)

    override fun lock(position: Long, size: Long, isShared: Boolean): FileLock = inner.lock(position, size, isShared)

    override fun tryLock(position: Long, size: Long, isShared: Boolean): FileLock? = inner.tryLock(position, size, isShared)

    override fun implCloseChannel() {
        inner.close()
        closed()
    }
}
