package badlog.wpilog

/** Turns the payloads of one entry into samples. */
internal abstract class PayloadDecoder {
    /** How many payloads did not have the bytes that the type asks for. */
    var badCount = 0

    /** How many values there was no topic left for. */
    var droppedValues = 0

    /** Whether the payloads are shown by their sizes only. */
    open val isUndecoded: Boolean get() = false

    /** The times of all good records. */
    abstract val clock: Clock

    /** What was made of them; may be empty. */
    abstract val blocks: List<SampleBlock>

    /** Takes the payload from [from] until [until] of a record at [time]. */
    abstract fun accept(time: Double, bytes: ByteArray, from: Int, until: Int)

    /** Says that no more payloads come. */
    open fun finish() = Unit
}
