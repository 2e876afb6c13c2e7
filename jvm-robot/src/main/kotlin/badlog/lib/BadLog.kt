package badlog.lib

import badlog.bag.BagTopic
import java.io.File
import java.util.Objects
import java.util.function.BooleanSupplier
import java.util.function.DoubleSupplier
import java.util.function.Function
import java.util.function.LongSupplier
import java.util.function.Supplier

/**
 * Logs what a robot does into a bag. There is one log at a time: [init] starts it, topics and values are created by the
 * functions that need no instance, [finishInitialization] writes the header, and then each loop calls [updateTopics]
 * and [log].
 *
 * While a log is set up, mistakes are exceptions. What a robot calls in its loop, [updateTopics], [log], [flush] and
 * publishing, never throws: what fails leaves a gap or is ignored, is counted (see [counters]), said once on standard
 * error and noted in the log's first event log, if it has one.
 *
 * All functions may be called by any thread. Suppliers are called by the thread that calls [updateTopics].
 */
public class BadLog private constructor(private val session: LogSession) : AutoCloseable {
    /** What it is doing. */
    public val state: LogState get() = session.state

    /** What it has been through so far. Makes an object, so it is not meant for every loop. */
    public fun counters(): LogCounters = session.faults.counters.snapshot()

    /**
     * Ends the set-up: writes the header.
     *
     * @throws InvalidModeException if that was done before.
     */
    public fun finishInitialization(): Unit = session.finishSetup()

    /** Asks all suppliers, and takes what was published. The values are those of all rows until the next call. */
    public fun updateTopics(): Unit = session.update()

    /** Writes a row with the values of the last [updateTopics]. */
    public fun log(): Unit = session.log()

    /** Writes the rows that still wait, if the log was started without writing each row at once. */
    public fun flush(): Unit = session.flush()

    /**
     * Sets how numbers become text, for all topics, also those created before. By default it is `%.5g`.
     *
     * @param function called while a row is put together, under the log's lock: it must be quick, and must not wait for
     *   other threads, which may be waiting for that lock.
     */
    public fun setDoubleToStringFunction(function: Function<in Double, out String?>) {
        session.text.function = function
    }

    /**
     * Switches off or on that rows are brought to the disk four times a second; on by default. Without it, a cut of
     * power may cost half a minute instead of a quarter of a second.
     */
    public fun setSyncing(enabled: Boolean): Unit = session.setSyncing(enabled)

    /** Writes what still waits, and closes the file. Calls that follow are ignored. */
    override fun close(): Unit = session.close()

    public companion object {
        /** The unit of data without a unit. */
        public const val UNITLESS: String = "ul"

        /** What stands in a subscriber's cell when there is nothing to put there. */
        public const val DEFAULT_DATA: String = "-1.0"

        @Volatile
        private var current: BadLog? = null

        /** Starts a log that writes each row at once. See the other [init] for what all have in common. */
        @JvmStatic
        public fun init(path: String): BadLog = init(path, compress = false, flush = true)

        /** Starts a log that writes several rows together. See the other [init] for what all have in common. */
        @JvmStatic
        public fun init(path: String, compress: Boolean?): BadLog = init(path, compress, flush = false)

        /**
         * Starts a log. Missing folders are created, a file of that name is replaced. If there is a log already, it is
         * closed first. When the file cannot be created, that is said on standard error and nothing is logged.
         *
         * @param path where to write, such as `/home/lvuser/logs/match.bag`.
         * @param compress true to write a gzip file; then `.gz` is added to [path].
         * @param flush true to write each row at once, false to write about a quarter of a second together.
         */
        @JvmStatic
        public fun init(path: String, compress: Boolean?, flush: Boolean?): BadLog {
            val isCompressed = compress == true
            val session = LogSession(flushesEachRow = flush == true)
            val log = start(session)
            session.open(File(if (isCompressed) "$path.gz" else path), isCompressed)
            return log
        }

        /**
         * Creates a topic of numbers.
         *
         * @param name letters, digits, spaces, `_` and `/`, which makes folders.
         * @param unit such as `V`, or [UNITLESS], as null is, too.
         * @param supplier asked in each [updateTopics].
         * @param attrs how it is to be shown, such as `hide` or `join:Drivetrain`; null is nothing.
         * @throws DuplicateNameException if there is a topic or value of that name.
         * @throws InvalidModeException before [init] or after [finishInitialization].
         */
        @JvmStatic
        public fun createTopic(name: String, unit: String?, supplier: Supplier<out Double?>, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(BoxedNumberTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier"), session.text))
        }

        /** Creates a topic of texts, as [createTopic] does. */
        @JvmStatic
        public fun createTopicStr(name: String, unit: String?, supplier: Supplier<out String?>, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(TextTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier")))
        }

        /** Creates a topic of numbers that costs no garbage, as [createTopic] does. */
        @JvmStatic
        public fun createTopicDouble(name: String, unit: String?, supplier: DoubleSupplier, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(NumberTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier"), session.text))
        }

        /** Creates a topic that is true or false, as [createTopic] does. */
        @JvmStatic
        public fun createTopicBoolean(name: String, unit: String?, supplier: BooleanSupplier, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(BooleanTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier")))
        }

        /** Creates a topic of whole numbers, written with all their digits, as [createTopic] does. */
        @JvmStatic
        public fun createTopicLong(name: String, unit: String?, supplier: LongSupplier, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(LongTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier")))
        }

        /**
         * Creates a topic whose values are published. [mode] says what it holds when nothing was. Otherwise as
         * [createTopic].
         */
        @JvmStatic
        public fun createTopicSubscriber(name: String, unit: String?, mode: DataInferMode, vararg attrs: String?) {
            createPublisher(name, unit, mode, *attrs)
        }

        /** Creates a topic as [createTopicSubscriber] does, and returns the quicker way to publish to it. */
        @JvmStatic
        public fun createPublisher(name: String, unit: String?, mode: DataInferMode, vararg attrs: String?): Publisher {
            val session = settingUp(name)
            val notes = EventTexts(session.faults.counters.eventsDropped)
            val topic = SubscribedTopic(described(name, unit, attrs), given(mode, "mode"), session.text, notes)
            return Publisher(session.add(topic), session.faults)
        }

        /** Creates an event log, a topic with the attribute `log`. Throws what [createTopic] does. */
        @JvmStatic
        public fun createEvents(name: String): Events {
            val session = settingUp(name)
            val topic = EventTopic(name, EventTexts(session.faults.counters.eventsDropped))
            return Events(session.add(topic), session.faults)
        }

        /** Creates a value: a text known now, such as the match's number; null is empty. Throws as [createTopic]. */
        @JvmStatic
        public fun createValue(name: String, value: String?): Unit = settingUp(name).addValue(name, value ?: "")

        /** Publishes a text to a subscriber topic. Never throws. */
        @JvmStatic
        public fun publish(name: String?, value: String?) {
            val topic = current?.session?.publishing(name, value == null)
            if (topic != null && value != null) topic.publish(value)
        }

        /** Publishes a number to a subscriber topic. Never throws. */
        @JvmStatic
        public fun publish(name: String?, value: Double) {
            current?.session?.publishing(name, false)?.publish(value)
        }

        /** Makes [session] the log in which topics are created, and closes the one before. */
        @Synchronized
        internal fun start(session: LogSession): BadLog {
            val before = current
            if (before != null && before.state != LogState.CLOSED) {
                StandardError.say("A new log was started while another was open; the other one was closed.")
                before.close()
            }
            return BadLog(session).also { current = it }
        }

        /** Java may hand over null, which is better said while the robot is set up than in its loop. */
        private fun <T : Any> given(argument: T, what: String): T =
            Objects.requireNonNull(argument, "The $what of a topic is null; give it one.")

        private fun described(name: String, unit: String?, attrs: Array<out String?>) =
            BagTopic(name, unit ?: UNITLESS, attrs.filterNotNull())

        private fun settingUp(name: String): LogSession {
            given(name, "name")
            return current?.session ?: throw InvalidModeException("\"$name\" was created too early: call BadLog.init(path) first.")
        }
    }
}
