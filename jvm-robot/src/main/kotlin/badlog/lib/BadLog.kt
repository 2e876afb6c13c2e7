package badlog.lib

import badlog.core.bag.BagTopic
import java.io.File
import java.util.Objects
import java.util.function.BooleanSupplier
import java.util.function.DoubleSupplier
import java.util.function.Function
import java.util.function.LongSupplier
import java.util.function.Supplier

/**
 * Logs a robot's data into a bag. There is one log at a time: [init] starts it, the static functions create topics and values,
 * [finishInitialization] writes the header, and then each loop calls [updateTopics] and [log].
 *
 * During setup, a mistake throws an exception. The functions that a robot calls in its loop, [updateTopics], [log], [flush] and those that
 * publish, never throw. A failure leaves a gap, or the call is ignored; it is counted (see [counters]), reported once on standard error,
 * and noted in the log's first event log, if there is one.
 *
 * All functions may be called from any thread. Suppliers are called on the thread that calls [updateTopics].
 */
public class BadLog private constructor(private val session: LogSession) : AutoCloseable {
    /** The current state of the log. */
    public val state: LogState get() = session.state

    /**
     * Returns the numbers of rows, cells and calls that were written, lost or ignored so far. Allocates an object, so do not call it in
     * every loop.
     */
    public fun counters(): LogCounters = session.faults.counters.snapshot()

    /**
     * Ends the setup and writes the header.
     *
     * @throws InvalidModeException if that was done before.
     */
    public fun finishInitialization(): Unit = session.finishSetup()

    /** Calls all suppliers, and takes over the published values. All rows until the next call have these values. */
    public fun updateTopics(): Unit = session.update()

    /** Writes a row with the values from the last [updateTopics]. */
    public fun log(): Unit = session.log()

    /** Writes the rows that are still buffered, if the log was started without writing each row at once. */
    public fun flush(): Unit = session.flush()

    /**
     * Sets how numbers are converted to text, for all topics, including those already created. Default: `%.5g`.
     *
     * @param function called while a row is built, with the log's lock held: it must be quick, and must not wait for
     *   other threads, which may be waiting for that lock.
     */
    public fun setDoubleToStringFunction(function: Function<in Double, out String?>) {
        session.text.function = function
    }

    /**
     * Sets whether rows are synced to the disk four times a second. Default: on. When off, a loss of power may cost
     * half a minute of data instead of a quarter of a second.
     */
    public fun setSyncing(enabled: Boolean): Unit = session.setSyncing(enabled)

    /** Writes the buffered rows, and closes the file. Later calls are ignored. */
    override fun close(): Unit = session.close()

    public companion object {
        /** The unit text for data without a unit. */
        public const val UNITLESS: String = "ul"

        /** The content of a subscriber topic's cell if there is no value. */
        public const val DEFAULT_DATA: String = "-1.0"

        @Volatile
        private var current: BadLog? = null

        /** Starts a log that writes each row at once. For details see the [init] with all parameters. */
        @JvmStatic
        public fun init(path: String): BadLog = init(path, compress = false, flush = true)

        /** Starts a log that writes several rows together. For details see the [init] with all parameters. */
        @JvmStatic
        public fun init(path: String, compress: Boolean?): BadLog = init(path, compress, flush = false)

        /**
         * Starts a log. Missing folders are created; an existing file of that name is replaced. If there already is a
         * log, it is closed first. If the file cannot be created, this is reported on standard error, and nothing is
         * logged.
         *
         * @param path the path of the file, such as `/home/lvuser/logs/match.bag`.
         * @param compress true to write a gzip file; then `.gz` is added to [path].
         * @param flush true to write each row at once, false to write the rows of about a quarter of a second
         * together.
         */
        @JvmStatic
        public fun init(path: String, compress: Boolean?, flush: Boolean?): BadLog =
            init(path, compress == true, LogSession(flushesEachRow = flush == true))

        /** Starts the log of [session] in the file at [path], with `.gz` added if it is compressed. */
        internal fun init(path: String, isCompressed: Boolean, session: LogSession): BadLog {
            val log = start(session)
            session.open(File(if (isCompressed) "$path.gz" else path), isCompressed)
            return log
        }

        /**
         * Creates a topic of numbers.
         *
         * @param name letters, digits, spaces, `_`, and `/` for folders.
         * @param unit such as `V`; [UNITLESS] or null for none.
         * @param supplier called in each [updateTopics].
         * @param attrs attributes for its display, such as `hide` or `join:Drivetrain`; null for none.
         * @throws DuplicateNameException if a topic or value of that name exists.
         * @throws InvalidModeException before [init] or after [finishInitialization].
         */
        @JvmStatic
        public fun createTopic(name: String, unit: String?, supplier: Supplier<out Double?>, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(BoxedNumberTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier"), session.text))
        }

        /** Creates a topic of texts, otherwise like [createTopic]. */
        @JvmStatic
        public fun createTopicStr(name: String, unit: String?, supplier: Supplier<out String?>, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(TextTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier")))
        }

        /** Creates a topic of numbers that produces no garbage; otherwise like [createTopic]. */
        @JvmStatic
        public fun createTopicDouble(name: String, unit: String?, supplier: DoubleSupplier, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(NumberTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier"), session.text))
        }

        /** Creates a topic that is true or false, otherwise like [createTopic]. */
        @JvmStatic
        public fun createTopicBoolean(name: String, unit: String?, supplier: BooleanSupplier, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(BooleanTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier")))
        }

        /** Creates a topic of whole numbers, written with all their digits; otherwise like [createTopic]. */
        @JvmStatic
        public fun createTopicLong(name: String, unit: String?, supplier: LongSupplier, vararg attrs: String?) {
            val session = settingUp(name)
            session.add(LongTopic(described(name, unit, attrs), session.faults, given(supplier, "supplier")))
        }

        /** Creates a topic for published values. [mode] decides its value if nothing was published. Otherwise like [createTopic].  */
        @JvmStatic
        public fun createTopicSubscriber(name: String, unit: String?, mode: DataInferMode, vararg attrs: String?) {
            createPublisher(name, unit, mode, *attrs)
        }

        /** Creates a topic like [createTopicSubscriber], and returns a faster way to publish to it. */
        @JvmStatic
        public fun createPublisher(name: String, unit: String?, mode: DataInferMode, vararg attrs: String?): Publisher {
            val session = settingUp(name)
            val notes = EventTexts(session.faults.counters.eventsDropped)
            val topic = SubscribedTopic(described(name, unit, attrs), given(mode, "mode"), session.text, notes)
            return Publisher(session.add(topic), session.faults)
        }

        /** Creates an event log: a topic with the attribute `log`. Throws the same exceptions as [createTopic]. */
        @JvmStatic
        public fun createEvents(name: String): Events {
            val session = settingUp(name)
            val topic = EventTopic(name, EventTexts(session.faults.counters.eventsDropped))
            return Events(session.add(topic), session.faults)
        }

        /**
         * Creates a value, a text that is already known, such as the match number. A null [value] counts as empty. Throws the same
         * exceptions as [createTopic].
         */
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

        /** Makes [session] the log in which topics are created, and closes the previous one. */
        @Synchronized
        internal fun start(session: LogSession): BadLog {
            val before = current
            if (before != null && before.state != LogState.CLOSED) {
                StandardError.print("A new log was started while another was open; the other one was closed.")
                before.close()
            }
            return BadLog(session).also { current = it }
        }

        /** Rejects a null from Java during setup, rather than in the robot's loop. */
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
