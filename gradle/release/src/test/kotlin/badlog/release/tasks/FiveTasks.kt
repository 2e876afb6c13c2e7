package badlog.release.tasks

/**
 * A small example of a task.
 *
 * @property optional the texts of links to files that other examples need, or that only explain.
 * @property steps performs the task.
 */
internal class ExampleOfTask(val optional: Set<String> = emptySet(), val steps: Walk.() -> Unit)

/** An example of each task that CONTRIBUTING.md leads through, by its title there. */
internal val EXAMPLES: Map<String, ExampleOfTask> = mapOf(
    "Read one more kind of log" to ExampleOfTask(optional = setOf("package for Python")) { addFormat() },
    "Add a function to formulas and questions" to ExampleOfTask(optional = setOf("SlowChanges", "SlowOccurrences")) { addFunction() },
    "Add a rule" to ExampleOfTask(optional = setOf("rules.md", "badlog-signals.toml", "What makes a rule proven")) { addRule() },
    "Add a key" to ExampleOfTask(optional = setOf("page and window")) { addKeys() },
    "Add a column to the list of logs" to ExampleOfTask { addColumn() },
)

/** Reads `.laps`: a line `LAPS`, then a CSV list. */
private fun Walk.addFormat() {
    add(
        "list",
        "../../laps/LapsFormat.kt",
        """
        package badlog.formats.laps

        import badlog.core.recording.LogFormat
        import badlog.core.recording.LogParser
        import badlog.core.recording.Recording
        import badlog.formats.list.ListFormat

        /** The laps of a robot on a bench: a line `LAPS`, then a CSV list. */
        internal object LapsFormat : LogFormat {
            override val id: String get() = "laps"

            override val title: String get() = "lap log"

            override val endings: List<String> get() = listOf(".laps")

            override val signatureSize: Int get() = SIGNATURE.length

            override fun matches(bytes: ByteArray, size: Int): Boolean = bytes.decodeToString(0, minOf(size, signatureSize)) == SIGNATURE

            override fun parser(keepSamples: Boolean): LogParser = LapsParser(ListFormat.parser(keepSamples))

            private const val SIGNATURE = "LAPS\n"
        }

        private class LapsParser(private val list: LogParser) : LogParser {
            private var skipped = 0

            override val rowCount: Int get() = list.rowCount
            override var maxRows: Int by list::maxRows
            override val isFull: Boolean get() = list.isFull

            override fun accept(bytes: ByteArray, from: Int, until: Int) {
                val first = minOf(until, from + LapsFormat.signatureSize - skipped)
                skipped += first - from
                list.accept(bytes, first, until)
            }

            override fun finish(): Recording = list.finish().copy(format = LapsFormat)
        }

        """.trimIndent(),
    )
    add(
        "list",
        "../../../../../../commonTest/kotlin/badlog/formats/laps/LapsFormatSpec.kt",
        """
        package badlog.formats.laps

        import badlog.core.bag.RecordingParser
        import badlog.formats.LOG_FORMATS
        import io.kotest.core.spec.style.FunSpec
        import io.kotest.matchers.shouldBe
        import io.kotest.matchers.types.shouldBeSameInstanceAs

        class LapsFormatSpec : FunSpec({
            test("a lap log is read as a list, in pieces of any size") {
                val bytes = "LAPS\nTimestamp,Name,Value\n0.5,Lap,1\n".encodeToByteArray()
                for (piece in listOf(1, 7, bytes.size)) {
                    val parser = RecordingParser(LOG_FORMATS)
                    for (at in bytes.indices step piece) parser.accept(bytes, at, minOf(at + piece, bytes.size))
                    val recording = parser.finish()
                    recording.format shouldBeSameInstanceAs LapsFormat
                    recording.topics.single().samples.toList() shouldBe listOf(1.0)
                }
            }
        })

        """.trimIndent(),
    )
    insert("LOG_FORMATS", "import badlog.formats.driverstation.DriverStationFormat\n", "import badlog.formats.laps.LapsFormat\n")
    insert("LOG_FORMATS", "RevlogFormat, ListFormat", ", LapsFormat")
    add("corpus", "../laps.laps", "LAPS\nTimestamp,Name,Value\n0.5,Lap,1\n0.7,Lap\n0.9,Lap,2\n")
    insert("wpilog.md", "\n## Other files read as a WPILOG\n", "\nA `.laps` is a line `LAPS` and a list of samples.\n")
}

/** Adds `width(x)`, the difference between the largest and the smallest value. */
private fun Walk.addFunction() {
    insert("Function", "import badlog.expression.samples.total\n", "import badlog.expression.samples.valueWidth\n")
    insert(
        "Function",
        "compute = { it.column(0).maximum() }),\n",
        "    WIDTH(\"width\", listOf(VARYING_NUMBERS), Result.NUMBER, unit = UnitOfResult.AS_FIRST, compute = { it.column(0).valueWidth() }),\n",
    )
    add(
        "samples",
        "ValueWidth.kt",
        "package badlog.expression.samples\n\n/** Returns the difference between the largest and the smallest value. */\n" +
            "internal fun Column.valueWidth(): Scalar = Scalar(maximum().value - minimum().value)\n",
    )
    insert(
        "SlowFigures",
        "Function.MAX -> numbers.maxOrNull()\n",
        "            Function.WIDTH -> if (numbers.isEmpty()) null else numbers.max() - numbers.min()\n",
    )
    insert("RandomExpressions", "\"sample_mean\", \"sample_median\", \"sample_stddev\",", " \"width\",")
    insert("LoggedEitherWaySpec", "\"first\", \"last\", \"integral\", \"duration\", \"time_of_min\", \"time_of_max\",", " \"width\",")
    insert("expressions.md", "| `time_of_min(x)` `time_of_max(x)` | |\n", "| `width(x)` | the largest value minus the smallest one |\n")
    insert("expressions.md", "```expression\nintegral(PDP/Total Current) / 3600\n", "width(Battery Voltage)\n")
}

/** Adds a rule about too much air, which needs no new signal. */
private fun Walk.addRule() {
    insert(
        "badlog-rules.toml",
        "next = \"Look for leaks, and count how often each cylinder moves in a match.\"\nshow = [\"compressor\"]\n",
        """

        [[rule]]
        name = "High air pressure"
        group = "pneumatics"
        severity = "warning"
        when = "(air pressure > {psi}) for {seconds} s"
        limits = { psi = 125, seconds = 1 }
        text = "The stored air rose to {value}, above {psi} psi for {duration}."
        why = "The compressor has to stop at 120 psi."
        next = "Check the pressure switch, and what starts the compressor."
        show = ["compressor"]

        """.trimIndent(),
    )
    insert("PlantedFaults", "    \"Low air pressure\" to { from(20.0, \"Pneumatics/Pressure\") { \"50\" } },\n", planted("130"))
    insert("NearMisses", "    \"Low air pressure\" to { from(20.0, \"Pneumatics/Pressure\") { \"61\" } },\n", planted("122"))
}

private fun planted(pressure: String) = "    \"High air pressure\" to { from(20.0, \"Pneumatics/Pressure\") { \"$pressure\" } },\n"

/** Adds a key with an effect in common code, and one that only a front end can perform. */
private fun Walk.addKeys() {
    insert(
        "KeyAction",
        "KeyStroke(\"E\")),\n",
        """

            /** Removes both cursors. */
            CLEAR_CURSORS("Graphs", "Remove the cursors", KeyStroke("U")),

            /** Announces the values at the cursor again. */
            REPEAT_VALUES("Graphs", "Say the values at the cursor again", KeyStroke("R")),

        """.trimIndent(),
    )
    insert(
        "Reduce",
        "KeyAction.SHOW_ENABLED -> showing { showingEnabled(shown.enabled) }\n",
        "    KeyAction.CLEAR_CURSORS -> Outcome(at(place.copy(cursors = Cursors())), Request.Cursor)\n" +
            "    KeyAction.REPEAT_VALUES -> Outcome(this, Request.Repeat)\n",
    )
    insert(
        "ReduceSpec",
        "beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.SECOND_CURSOR, KeyAction.SECOND_CURSOR).place.cursors.second shouldBe null\n    }\n",
        """

        test("a key removes both cursors") {
            beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.SECOND_CURSOR, KeyAction.CLEAR_CURSORS).place.cursors shouldBe Cursors()
        }

        """.trimIndent(),
    )
    insert("Request", "    object Cursor : Request\n", "\n    /** Announces the values at the cursor again. */\n    object Repeat : Request\n")
    insert("PageRequests", "    Request.Cursor -> live.announceCursor()\n", "\n    Request.Repeat -> live.announceCursor()\n")
    insert("WindowRequests", "    Request.Cursor -> spoken.sayValues()\n", "\n    Request.Repeat -> spoken.sayValues()\n")
    insert("log.md", "| `E` | zoom to the time enabled |\n", "| `U`, `R` | remove the cursors; say the values at the cursor again |\n")
}

/** Adds the number of a log's values, which is not known without reading it. */
private fun Walk.addColumn() {
    insert("LogSummary", " * @property topics the topics with numbers, in the order of the file.\n", " * @property values the number of its values.\n")
    insert("LogSummary", "    val topics: List<TopicSummary> = emptyList(),\n", "    val values: Int = 0,\n")
    insert("LogSummary", "                topics = topics,\n", "                values = recording.values.size,\n")
    insert("SummarySerializer", "    val topics: List<StoredTopic>,\n", "    val values: Int,\n")
    insert("SummarySerializer", "        topics.map { it.topic() },\n", "        values,\n")
    insert("SummarySerializer", "                topics.map { StoredTopic.of(it) },\n", "                values,\n")
    insert("SummaryMessage", "        \"numbers\" to numbersOf(summary.topics),\n", "        \"values\" to summary.values,\n")
    insert("SummaryMessage", "            topics = topicsIn(message, battery?.topic),\n", "            values = message.values as Int,\n")
    val version = checkNotNull(Regex("const val VERSION = (\\d+)").find(named("ResultCache").readText()))
    replace("ResultCache", version.value, "const val VERSION = ${version.groupValues[1].toInt() + 1}")
    insert(
        "LogColumn",
        "text = ::batteryText),\n",
        "    VALUES(\"Values\", compareBy { it.summary.values }, isNumber = true, text = { countText(it.summary.values) }),\n",
    )
    insert(
        "ListingSpec",
        "class ListingSpec : FunSpec({\n",
        """
            test("the column of values has their number") {
                LogColumn.VALUES.text(AnyLog("a.bag", LogSummary(date = LogDate(0, DateSource.VALUES), values = 3), null)) shouldBe "3"
            }


        """.trimIndent(),
    )
}
