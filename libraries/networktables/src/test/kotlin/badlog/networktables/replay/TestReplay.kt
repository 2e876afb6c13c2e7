package badlog.networktables.replay

import badlog.core.analysis.LogView
import badlog.core.waiting.eventually
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.TimeUnit

/** A replay with a clock that only a test advances. Between advances it sends nothing by itself. */
internal class TestReplay(
    view: LogView = VARIED_VIEW,
    options: ReplayOptions = ReplayOptions(0),
    logged: List<LoggedTopic> = emptyList(),
) : AutoCloseable {
    @Volatile
    private var nanos = 0L
    val server = ReplayServer(view, options, logged, { nanos }, NoTicks()).apply { open() }

    /** Advances by 10 ms, and sends due values to clients that have received the earlier ones. */
    fun tick(): Boolean {
        nanos += 10_000_000
        return server.tick()
    }

    /** Sends due values to all clients. */
    fun sendDue() = eventually("the clients to take what was sent") { server.tick() }

    /** Advances [count] times by 10 ms; due values are sent to all clients each time. */
    fun advance(count: Int = 1) = repeat(count) {
        tick()
        sendDue()
    }

    fun playToEnd() {
        server.start()
        while (!server.isAtEnd) advance()
    }

    override fun close() = server.close()

    /** A scheduler that runs nothing. */
    private class NoTicks : ScheduledThreadPoolExecutor(1) {
        override fun scheduleAtFixedRate(command: Runnable, delay: Long, period: Long, unit: TimeUnit): ScheduledFuture<*> = schedule(command, Long.MAX_VALUE, TimeUnit.NANOSECONDS)
    }
}
