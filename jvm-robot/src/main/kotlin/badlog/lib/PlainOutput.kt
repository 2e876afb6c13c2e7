package badlog.lib

/** A bag as it is. */
internal class PlainOutput(private val file: AppendFile) : BagOutput {
    override val length: Long get() = file.length

    override fun append(bytes: ByteArray, size: Int) = file.append(bytes, size)

    override fun finish() = Unit

    override fun sync() = file.sync()

    override fun close() = file.close()
}
