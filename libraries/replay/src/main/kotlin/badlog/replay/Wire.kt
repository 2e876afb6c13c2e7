package badlog.replay

import java.nio.ByteBuffer

/** The way to one client. Nothing here waits: what cannot go out at once is kept until it can. */
internal interface Wire {
    /** Whether something is still kept, because the client reads more slowly than it is written to. */
    val isBusy: Boolean

    fun send(text: String)

    fun send(binary: ByteBuffer)
}
