package badlog.lib

import java.io.File
import java.io.IOException
import java.io.RandomAccessFile
import java.util.zip.CRC32
import java.util.zip.Deflater

/** Where the bytes of a bag go. */
internal interface BagOutput {
    /** The current length of the file in bytes. */
    val length: Long

    /** @throws IOException if the bytes could not be written; the file is then unchanged. */
    fun append(bytes: ByteArray, size: Int)

    /** Writes what belongs at the end of the file. */
    fun finish()

    /** Waits until everything is on the disk. */
    fun sync()

    fun close()
}

/** An uncompressed bag. */
internal class PlainOutput(private val file: AppendFile) : BagOutput {
    override val length: Long get() = file.length

    override fun append(bytes: ByteArray, size: Int) = file.append(bytes, size)

    override fun finish() = Unit

    override fun sync() = file.sync()

    override fun close() = file.close()
}

/**
 * A gzipped bag. Each [append] ends on a byte's boundary (zlib's sync flush), so that everything appended can be
 * inflated from a file that was cut anywhere after it.
 */
internal class GzipOutput(private val file: AppendFile) : BagOutput {
    private val deflater = Deflater(Deflater.DEFAULT_COMPRESSION, true)
    private val checksum = CRC32()
    private var packed = ByteArray(4096)
    private var packedSize = 0
    private var unpackedLength = 0L

    override val length: Long get() = file.length

    override fun append(bytes: ByteArray, size: Int) {
        packedSize = 0
        if (file.length == 0L) putHeader()
        deflater.setInput(bytes, 0, size)
        deflate(Deflater.SYNC_FLUSH)
        write()
        checksum.update(bytes, 0, size)
        unpackedLength += size
    }

    override fun finish() {
        packedSize = 0
        if (file.length == 0L) putHeader()
        deflater.finish()
        deflate(Deflater.NO_FLUSH)
        putLittleEndian(checksum.value.toInt())
        putLittleEndian(unpackedLength.toInt())
        write()
    }

    override fun sync() = file.sync()

    override fun close() {
        deflater.end()
        file.close()
    }

    private fun write() {
        try {
            file.append(packed, packedSize)
        } catch (failure: IOException) {
            // What follows must not refer back to bytes that are not in the file. The stream continues from the last success.
            deflater.reset()
            throw failure
        }
    }

    private fun deflate(flush: Int) {
        while (true) {
            if (packedSize == packed.size) packed = packed.copyOf(packed.size * 2)
            packedSize += deflater.deflate(packed, packedSize, packed.size - packedSize, flush)
            if (packedSize < packed.size) return
        }
    }

    private fun putHeader() {
        // Magic number, method "deflate", no flags, no time, no hints, unknown system.
        HEADER.copyInto(packed)
        packedSize = HEADER.size
    }

    private fun putLittleEndian(value: Int) {
        if (packedSize + Int.SIZE_BYTES > packed.size) packed = packed.copyOf(packed.size * 2)
        for (shift in 0 until Int.SIZE_BITS step Byte.SIZE_BITS) packed[packedSize++] = (value ushr shift).toByte()
    }

    private companion object {
        val HEADER = byteArrayOf(0x1f, 0x8b.toByte(), 8, 0, 0, 0, 0, 0, 0, 0xff.toByte())
    }
}

/**
 * A file that only grows, by one `write` for each [append]. A failed [append] leaves the file unchanged.
 *
 * It uses a [RandomAccessFile] because interrupting a thread does not close it, unlike a channel, and because it
 * writes up to 8 kB via the stack, without allocating a buffer.
 *
 * @param file created or truncated; missing folders are created.
 * @throws IOException if that fails.
 */
internal class AppendFile(file: File) {
    private val access: RandomAccessFile
    private var isTorn = false

    /** The number of bytes appended. */
    var length: Long = 0
        private set

    init {
        file.absoluteFile.parentFile?.mkdirs()
        access = RandomAccessFile(file, "rw")
        try {
            access.setLength(0)
        } catch (failure: IOException) {
            // Not a regular file, such as a pipe: it has no length to reset.
            if (file.isFile) throw failure
        }
    }

    /** @throws IOException if not all bytes could be written; then none are in the file, and the next call may try again. */
    fun append(bytes: ByteArray, size: Int) {
        if (isTorn) cutTornEnd()
        try {
            access.write(bytes, 0, size)
        } catch (failure: IOException) {
            isTorn = true
            try {
                cutTornEnd()
            } catch (_: IOException) {
                // Tried again before the next row; a file that has disappeared cannot be truncated.
            }
            throw failure
        }
        length += size
    }

    /** Waits until everything is on the disk. Only for a thread that has nothing else to do. */
    fun sync() = access.fd.sync()

    fun close() = access.close()

    private fun cutTornEnd() {
        access.setLength(length)
        access.seek(length)
        isTorn = false
    }
}
