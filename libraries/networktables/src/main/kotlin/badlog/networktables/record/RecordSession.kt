package badlog.networktables.record

import badlog.networktables.TopicType
import kotlinx.serialization.json.add
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonArray
import kotlinx.serialization.json.putJsonObject

/**
 * Handles the events of all servers and decides which values are written. Use it on one thread; the functions throw [java.io.IOException]
 * if the log cannot be written.
 *
 * @param sources the servers; the first is the robot's, and the log uses its clock.
 * @param dropped returns the number of values dropped so far.
 * @param clock returns this computer's time in µs, from an arbitrary origin.
 */
internal class RecordSession(
    private val sources: List<Source>,
    private val options: RecordOptions,
    private val listener: RecordListener,
    private val dropped: () -> Long,
    private val clock: () -> Long,
) {
    private val robot = sources.first()
    private val output = LogOutput(options)
    private var match = LiveMatch()
    private var subscriptions = 0
    private var ignored = 0L
    private var flushedMicros = 0L
    private var disabledMicros = 0L
    private var connectedMicros = 0L
    private var isSilenceNoted = false

    /** The current progress. */
    val progress: RecordProgress get() = output.progress(robot.isSubscribed)

    fun take(incoming: Incoming) {
        val source = incoming.link.source
        if (incoming is Incoming.Opened) return opened(source, incoming.link)
        // The connection has been replaced.
        if (source.link !== incoming.link) return
        when (incoming) {
            is Incoming.Text -> for (message in serverMessages(incoming.text) { ignore(source, it) }) take(source, message)
            is Incoming.Values -> readValues(incoming.frame, Values(source, incoming.localMicros))
            is Incoming.Closed -> closed(source, incoming)
            is Incoming.Opened -> Unit
        }
    }

    fun tick() {
        val now = clock()
        if (now - flushedMicros < FLUSH_MICROS) return
        flushedMicros = now
        val isOver = options.isPerEnable && match.isEnabled == false && now - disabledMicros > PAUSE_MICROS
        if (isOver && robot.isSubscribed) finish() else output.tick(robotMicros(), dropped())
        val isSilent = options.isPerEnable && robot.isSubscribed && match.isEnabled == null && now - connectedMicros > PAUSE_MICROS
        if (isSilent && !isSilenceNoted) {
            isSilenceNoted = true
            val missing = "neither ${LiveMatch.CONTROL} nor ${LiveMatch.CONTROL_2027}"
            note("The robot publishes $missing, so it is not known when it is enabled; record the whole session instead.")
        }
    }

    /** Ends the file at [micros]. */
    fun finish(micros: Long = robotMicros()) {
        output.close(micros, dropped(), ignored)?.let(listener::finished)
        ignored = 0
    }

    private fun opened(source: Source, link: Link) {
        source.link = link
        source.isSubscribed = false
        source.byId.clear()
    }

    private fun closed(source: Source, closed: Incoming.Closed) {
        val wasSubscribed = source.isSubscribed
        source.link = null
        source.isSubscribed = false
        source.sync.disconnected()
        if (!wasSubscribed) return
        val name = source.server.name
        output.connected(source, false, logMicros(source, closed.localMicros + (source.sync.offset ?: 0)))
        output.message("The connection to the $name was lost: ${closed.reason}.", robotMicros())
        listener.disconnected(name, closed.reason)
    }

    private fun answered(source: Source, sent: Long, server: Long, local: Long) {
        val before = robotMicros()
        val isAnother = source.sync.answered(sent, server, local)
        if (isAnother) clockChanged(source, before)
        val link = source.link ?: return
        if (source.isSubscribed) {
            // The server's values have times of its former clock; after reconnecting it sends them with the new one.
            if (isAnother) link.close("its clock was set")
            return
        }
        source.isSubscribed = true
        subscribe(link, "", isAll = options.isWanted == null)
        if (options.isWanted != null) LiveMatch.FOLDERS.forEach { subscribe(link, it, isAll = true) }
        if (options.isWanted != null) subscribe(link, SCHEMAS, isAll = true)
        if (source.isRobot) connectedMicros = local
        if (output.isOpen) {
            output.connected(source, true, robotMicros())
        } else if (source.isRobot && !options.isPerEnable) {
            open(robotMicros())
        }
        output.message("Connected to the ${source.server.name} at ${link.address}.", robotMicros())
        listener.connected(source.server.name, link.address)
    }

    /** Handles a new clock of the server of [source]; its former clock would now show [before]. */
    private fun clockChanged(source: Source, before: Long) {
        val name = source.server.name
        if (source.isRobot) {
            val text = "The clock of the $name started again, as after a restart of its program; a new log begins."
            if (output.isOpen) listener.noted(text)
            output.message(text, before)
            finish(before)
            match = LiveMatch()
        } else {
            note("The clock of the $name started again, as after a restart of its program; its values keep the robot's time.")
        }
        source.byName.clear()
        source.byId.clear()
    }

    private fun subscribe(link: Link, name: String, isAll: Boolean, isPrefix: Boolean = true) {
        val id = ++subscriptions
        val request = buildJsonArray {
            addJsonObject {
                put("method", "subscribe")
                putJsonObject("params") {
                    putJsonArray("topics") { add(name) }
                    put("subuid", id)
                    putJsonObject("options") {
                        put("periodic", PERIOD_SECONDS)
                        if (isPrefix) put("prefix", true)
                        put(if (isAll) "all" else "topicsonly", true)
                    }
                }
            }
        }
        link.send(request.toString())
    }

    private fun take(source: Source, message: ServerMessage) {
        when (message) {
            is ServerMessage.Announce -> announced(source, message)

            is ServerMessage.Unannounce -> {
                source.byId.remove(message.id)
                source.byName.remove(message.name)?.let { output.unannounced(it, robotMicros()) }
            }

            is ServerMessage.Properties -> source.byName[message.name]?.let {
                it.update(message.update)
                output.described(it, robotMicros())
            }
        }
    }

    private fun announced(source: Source, message: ServerMessage.Announce) {
        val logName = source.server.prefix + message.name
        val isAlways = message.name.startsWith(SCHEMAS) || LiveMatch.isMatchTopic(message.name)
        val wanted = options.isWanted
        if (wanted != null && !isAlways && !wanted(logName)) return
        if (source.server.isMirror && message.name in robot.byName) return
        if (source.isRobot) sources.filter { it.server.isMirror }.forEach { unmirror(it, message.name) }
        val known = source.byName[message.name]
        val topic = if (known != null && known.typeName == message.type) {
            known.also { redescribe(it, message) }
        } else {
            if (source.byName.size >= Source.MAX_TOPICS) return ignore(source, "more than ${Source.MAX_TOPICS} topics")
            known?.let { output.unannounced(it, robotMicros()) }
            RecordedTopic(message.name, message.type, logName, message.properties).also { source.byName[message.name] = it }
        }
        topic.isRepeating = true
        source.byId[message.id] = topic
        output.announced(topic, robotMicros())
        if (wanted != null && !isAlways) source.link?.let { subscribe(it, message.name, isAll = true, isPrefix = false) }
    }

    /** Stops recording the topic [name] from the mirror [source], which announced it before the robot did. */
    private fun unmirror(source: Source, name: String) {
        val topic = source.byName.remove(name) ?: return
        source.byId.values.remove(topic)
        output.unannounced(topic, robotMicros())
    }

    private fun redescribe(topic: RecordedTopic, message: ServerMessage.Announce) {
        if (topic.properties == message.properties) return
        topic.replaceProperties(message.properties)
        output.described(topic, robotMicros())
    }

    private inner class Values(private val source: Source, private val localMicros: Long) : ValueSink {
        override fun typeOf(id: Long): TopicType? {
            val topic = source.byId[id]
            // Values follow their topic's announcement; unknown ids belong to topics that are not recorded.
            return topic?.type
        }

        override fun value(id: Long, micros: Long, payload: ByteArray) {
            val topic = source.byId[id] ?: return
            val time = logMicros(source, micros)
            if (topic.isRepeating) {
                topic.isRepeating = false
                if (output.has(topic, time, payload)) return
            }
            topic.latest = payload
            topic.latestMicros = micros
            val wasOpen = output.isOpen
            if (source.isRobot && LiveMatch.isMatchTopic(topic.name)) handle(topic, payload)
            // A file opened because of this value already contains it.
            val isInOrder = if (wasOpen) output.value(topic, time) else true
            if (!isInOrder) {
                note(
                    "“${topic.logName}” has a value with an earlier time than the one before; more such values are only counted.",
                )
            }
        }

        override fun time(serverMicros: Long, sentMicros: Long) = answered(source, sentMicros, serverMicros, localMicros)

        override fun ignored(what: String) = ignore(source, what)
    }

    private fun handle(topic: RecordedTopic, payload: ByteArray) {
        val was = match.isEnabled
        match.handle(topic.name, payload)
        val isEnabled = match.isEnabled
        if (was != isEnabled && isEnabled == false) disabledMicros = clock()
        if (options.isPerEnable && isEnabled == true && !output.isOpen) open(topic.latestMicros)
        if (options.isRenamed) match.nameEnd?.let(output::match)
    }

    private fun open(micros: Long) {
        output.open(sources, micros, dropped(), ::logMicros)
        match.nameEnd?.let(output::match)
    }

    /** Returns the robot's current time; 0 if unknown, in which case no file is open. */
    private fun robotMicros(): Long = robot.sync.offset?.let { clock() + it } ?: 0

    /** Converts [micros] of the server of [source] to the robot's time. */
    private fun logMicros(source: Source, micros: Long): Long {
        val ownOffset = source.sync.offset
        val robotOffset = robot.sync.offset
        return if (source.isRobot || ownOffset == null || robotOffset == null) micros else micros - ownOffset + robotOffset
    }

    private fun ignore(source: Source, what: String) {
        if (ignored++ == 0L) note("The ${source.server.name} sent $what; what cannot be read is left out and counted.")
    }

    private fun note(message: String) {
        output.message(message, robotMicros())
        listener.noted(message)
    }
}

private const val SCHEMAS = "/.schema/"

/** The period at which the server sends values. */
private const val PERIOD_SECONDS = 0.05

/** The time between flushes. With it, the server's period, and a sync each 100 ms, a power cut costs less than 0.25 s of data. */
private const val FLUSH_MICROS = 50_000L

/** The time after which the file of a disabled robot ends. Between autonomous and teleop, a robot is disabled for a few seconds. */
private const val PAUSE_MICROS = 15_000_000L
