package badlog.networktables.replay

import badlog.core.analysis.LogView
import badlog.core.waiting.eventually
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.ScheduledThreadPoolExecutor
import java.util.concurrent.TimeUnit

/** A replay whose time a test lets pass: meanwhile its clock stands still, and it sends nothing of its own accord. */
internal class TestReplay(
    view: LogView = VARIED_VIEW,
    options: ReplayOptions = ReplayOptions(0),
    logged: List<LoggedTopic> = emptyList(),
) : AutoCloseable {
    @Volatile
    private var nanos = 0L
    val server = ReplayServer(view, options, logged, { nanos }, NoTicks()).apply { open() }

    /** Lets 10 ms pass, and what is due be sent to the clients that have taken what was sent before. */
    fun tick(): Boolean {
        nanos += 10_000_000
        return server.tick()
    }

    /** Lets what is due be sent to all clients. */
    fun sendDue() = eventually("the clients to take what was sent") { server.tick() }

    /** Lets [count] times 10 ms pass; what is due is sent to all clients each time. */
    fun advance(count: Int = 1) = repeat(count) {
        tick()
        sendDue()
    }

    fun playToEnd() {
        server.start()
        while (!server.isAtEnd) advance()
    }

    override fun close() = server.close()

    /** Calls nothing. */
    private class NoTicks : ScheduledThreadPoolExecutor(1) {
        override fun scheduleAtFixedRate(command: Runnable, delay: Long, period: Long, unit: TimeUnit): ScheduledFuture<*> = schedule(command, Long.MAX_VALUE, TimeUnit.NANOSECONDS)
    }
}
