package badlog.networktables.record

import java.net.http.HttpClient
import java.time.Duration

/** Keeps [source] connected: finds the server, connects, requests its time, and starts over after a lost connection. */
internal class LinkThread(
    private val source: Source,
    private val client: HttpClient,
    private val inbox: Inbox,
    private val clock: () -> Long,
) : Thread("record ${source.server.name}") {
    @Volatile
    private var isEnded = false

    init {
        isDaemon = true
    }

    override fun run() {
        try {
            while (!isEnded) {
                source.server.find()?.let(::hold)
                sleep(RETRY_MILLIS)
            }
        } catch (_: InterruptedException) {
            // The thread was ended.
        }
    }

    private fun hold(address: ServerAddress) {
        val link = Link(source, address, inbox, clock)
        try {
            if (!link.open(client)) return
            while (!isEnded && !link.isClosed) {
                link.askTime()
                sleep(ASK_MILLIS)
                if (clock() - link.receivedMicros > SILENCE_MICROS) link.close("it has been silent for 3 s")
            }
        } finally {
            link.end()
        }
    }

    /** Ends the thread and its connection without waiting. */
    fun end() {
        isEnded = true
        interrupt()
    }

    companion object {
        private const val RETRY_MILLIS = 500L
        private const val ASK_MILLIS = 500L
        private const val SILENCE_MICROS = 3_000_000L

        fun client(): HttpClient = HttpClient.newBuilder().connectTimeout(Duration.ofSeconds(2)).build()
    }
}
