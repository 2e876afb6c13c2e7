package badlog.networktables.replay

import badlog.core.analysis.LogView
import badlog.networktables.SubProtocol
import java.io.Closeable
import java.net.InetSocketAddress
import java.util.concurrent.Executors
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.TimeUnit

/**
 * Replays a recording in real time to dashboards, as a NetworkTables 4 server with the recording's topics. Numbers are `double`, truth
 * values `boolean`, states and events `string`, and the header's values are strings below `/Values/`. The unit is the property `unit`.
 * `/FMSInfo/FMSControlData` shows when the robot was enabled, as on a robot.
 *
 * Thread-safe. Its own threads end with [close], and do not keep a program running.
 *
 * @property options the settings of the replay.
 * @param logged topics that are sent as logged, with their original types; they replace all topics of the recording but calculated ones.
 * @param nanos returns the time in ns, from an arbitrary origin.
 * @param ticks periodically sends values and checks the connections; ends with [close].
 */
class ReplayServer internal constructor(
    view: LogView,
    val options: ReplayOptions,
    logged: List<LoggedTopic>,
    private val nanos: () -> Long,
    private val ticks: ScheduledExecutorService,
) : Closeable {
    constructor(view: LogView, options: ReplayOptions = ReplayOptions(), logged: List<LoggedTopic> = emptyList()) : this(
        view,
        options,
        logged,
        System::nanoTime,
        Executors.newSingleThreadScheduledExecutor { Thread(it, "replay").apply { isDaemon = true } },
    )

    private val signals = signalsOf(view, options.prefix, logged)
    private val startNanos = nanos()
    private val ignored = IgnoredMessages()
    private val frames = ValueFrames(signals)
    private val clients = LinkedHashMap<Connection, Client>()
    private val player = Player(
        signals,
        Playhead(
            options.range ?: rangeOf(signals),
            unitsPerSecond(view.xAxis),
            options.speed,
            options.isLooping,
            serverNanos(),
        ),
    )
    private val playhead = player.playhead
    private val sockets = SocketServer(
        InetSocketAddress(options.address, options.port),
        { serverNanos() / NANOS_PER_MICRO },
        Connections(),
        ignored,
    )
    private var isBound = false

    // Guards the player and the clients.
    private val lock = Any()

    /** The part of the x axis that is replayed. */
    val range: ClosedFloatingPointRange<Double> get() = playhead.range

    /** The current position on the x axis. */
    val position: Double get() = synchronized(lock) { playhead.position(serverNanos()) }

    /** Whether it is playing; at the end, it still counts as playing until [pause]. */
    val isPlaying: Boolean get() = synchronized(lock) { playhead.isPlaying }

    /** Whether there is nothing left to play; always false while looping. Dashboards still see the last values. */
    val isAtEnd: Boolean get() = synchronized(lock) { playhead.isAtEnd(serverNanos()) }

    /** The port at which dashboards connect. */
    val port: Int get() = sockets.port

    /** The names of the connected dashboards, in the order in which they connected. */
    val clientNames: List<String> get() = synchronized(lock) { clients.keys.map { it.name } }

    /** A sentence about messages of dashboards that were not understood; null if there were none. */
    val note: String? get() = ignored.note

    /** A sentence about the first dashboard that was refused because there were too many; null if there was none. */
    val refusal: String? get() = ignored.refusal

    /** The number of messages of dashboards that were not understood. */
    val ignoredMessages: Int get() = ignored.count

    /** The number of seconds of the recording that pass in a second; above 0. */
    var speed: Double
        get() = synchronized(lock) { playhead.speed }
        set(value) = change { playhead.changeSpeed(value, it) }

    /**
     * Lets dashboards connect. They see the first values until [start], which also calls this function.
     *
     * @throws UnavailablePortException if the port is in use or unavailable.
     * @throws IllegalStateException after [close].
     */
    fun open() {
        synchronized(lock) {
            check(!ticks.isShutdown) { "This replay is closed." }
            if (isBound) return
            sockets.open()
            isBound = true
        }
        ticks.scheduleAtFixedRate({ tick() }, 0, TICK_MILLIS, TimeUnit.MILLISECONDS)
        ticks.scheduleAtFixedRate(::checkAlive, PING_SECONDS, PING_SECONDS, TimeUnit.SECONDS)
    }

    /** Continues from the current position, or from the start if it is at the end. Throws the same exceptions as [open]. */
    fun start() {
        open()
        change {
            if (playhead.isAtEnd(it)) playhead.seek(range.start, it)
            playhead.play(it)
        }
    }

    /** Pauses at the current position. */
    fun pause(): Unit = change { playhead.pause(it) }

    /**
     * Jumps to [position], or to the nearer end of [range]; dashboards receive the values that hold there.
     *
     * @throws IllegalArgumentException if it is NaN.
     */
    fun seek(position: Double): Unit = change { playhead.seek(position, it) }

    /** Ends all connections and frees the port. Waits for up to a second. */
    override fun close() {
        ticks.shutdownNow()
        sockets.stop(CLOSING_MILLIS)
    }

    /** Sends everything played with the old settings before [action] changes them. */
    private fun change(action: (nowNanos: Long) -> Unit) = synchronized(lock) {
        val now = serverNanos()
        offer(player.advance(now))
        action(now)
    }

    /** Sends due values. Returns whether all were sent; a client that has not yet received earlier ones gets none. */
    internal fun tick(): Boolean = synchronized(lock) {
        val now = serverNanos()
        offer(player.advance(now))
        sockets.writeQueued()
        clients.values.map { it.flush(now / NANOS_PER_MICRO) }.all { it }
    }

    /** Writes the data that clients have not received yet, see [SocketServer.writeQueued]; each [tick] does, too. */
    internal fun writeQueued() = sockets.writeQueued()

    private fun offer(updates: List<Update>) {
        if (updates.isNotEmpty()) for (client in clients.values) client.offer(updates)
    }

    private fun checkAlive() {
        val modern = synchronized(lock) { clients.keys.filter { it.protocol == SubProtocol.V4_1 } }
        val oldest = serverNanos() / NANOS_PER_MICRO - SILENCE_MICROS
        for (connection in modern) {
            if (connection.receivedMicros < oldest) connection.end("It has been silent for too long.") else connection.ping()
        }
    }

    // A robot's clock is never at 0 when it sends; a value with that time would count as a default.
    private fun serverNanos() = nanos() - startNanos + FIRST_NANOS

    private inner class Connections : Listener {
        override fun opened(connection: Connection) {
            if (connection.protocol == SubProtocol.TIME_ONLY) return
            val client = Client(player, connection, frames) { ignored.add(connection.name, it) }
            synchronized(lock) { clients[connection] = client }
        }

        override fun received(connection: Connection, text: String) = synchronized(lock) {
            clients[connection]?.receive(text) ?: Unit
        }

        override fun closed(connection: Connection) {
            synchronized(lock) { clients.remove(connection) }
        }
    }
}

private const val NANOS_PER_MICRO = 1000
private const val FIRST_NANOS = 1_000_000_000L
private const val TICK_MILLIS = 10L
private const val PING_SECONDS = 1L
private const val SILENCE_MICROS = 10_000_000L
private const val CLOSING_MILLIS = 1000
