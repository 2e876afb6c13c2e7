package badlog.lib

import java.io.File
import java.io.IOException
import java.util.zip.CRC32
import java.util.zip.Deflater

/** The destination of a bag's bytes. */
internal interface BagOutput {
    /** The current length of the file in bytes. */
    val length: Long

    /**
     * Appends the first [size] of [bytes].
     *
     * @throws IOException if they could not be written; the file is then unchanged.
     */
    fun append(bytes: ByteArray, size: Int)

    /** Writes the end of the file. */
    fun finish()

    /** Waits until everything is on the disk. */
    fun sync()

    /** Renames the file. Writers must hold [lock] while they append. If renaming fails, returns false, and the name is unchanged. */
    fun rename(to: File, lock: Any): Boolean

    fun close()
}

/** An uncompressed bag. */
internal class PlainOutput(private val file: AppendFile) : BagOutput {
    override val length: Long get() = file.length

    override fun append(bytes: ByteArray, size: Int) = file.append(bytes, size)

    override fun finish() = Unit

    override fun sync() = file.sync()

    override fun rename(to: File, lock: Any) = file.rename(to, lock)

    override fun close() = file.close()
}

/**
 * A gzipped bag. Each [append] ends on a byte boundary (zlib's sync flush). A file that is cut off later can be inflated up to that point.
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

    override fun rename(to: File, lock: Any) = file.rename(to, lock)

    override fun close() {
        deflater.end()
        file.close()
    }

    private fun write() {
        try {
            file.append(packed, packedSize)
        } catch (failure: IOException) {
            // The following bytes must not refer to bytes that are not in the file. The stream continues from the last success.
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
