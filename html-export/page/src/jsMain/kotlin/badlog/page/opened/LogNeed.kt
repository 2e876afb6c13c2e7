package badlog.page.opened

import badlog.core.analysis.LogView
import badlog.core.analysis.enabledTopics
import badlog.core.recording.Recording
import badlog.core.recording.Topic
import badlog.page.reading.LogFileReader
import badlog.page.reading.WantedTopics
import badlog.rules.RuleProgram
import badlog.rules.RuleSet
import badlog.signals.LogShape
import badlog.signals.signalTopicsOf
import badlog.signals.withSignals
import kotlinx.browser.window
import org.w3c.files.File
import kotlin.js.Promise
import kotlin.math.roundToInt

/**
 * What a large log is about to need, estimated from its beginning.
 *
 * @property bytes the memory for all of it.
 * @property fewBytes the memory for [few].
 * @property few the topics that are signals, or that rules look at.
 */
internal class LogNeed private constructor(val bytes: Double, val fewBytes: Double, val few: WantedTopics) {
    /** Whether this browser may not have so much. */
    val isTooMuch: Boolean get() = bytes > most

    companion object {
        /** Smaller files need not be looked at. */
        private const val SMALL = 20e6
        private const val HEAD = 2e6

        /** A page itself, in bytes. */
        private const val PAGE = 150e6

        /** Arrays are larger than what is in them while they grow. */
        private const val GROWTH = 1.5

        /** A browser gives a page a part of its device's memory, of which it shows at most 8 GB. */
        private val most: Double get() {
            val memory = window.navigator.asDynamic().deviceMemory as Double?
            return minOf(1.5e9, (memory ?: if (window.matchMedia("(pointer: coarse)").matches) 2.0 else 8.0) * 0.2e9)
        }

        /** Promises it for the log in [files] and [rules]; null for a small log. */
        fun of(files: List<File>, rules: RuleSet): Promise<LogNeed?> {
            val size = files.sumOf { it.size.toDouble() }
            if (size < SMALL) return Promise.resolve(null)
            val head = File(arrayOf(files[0].asDynamic().slice(0, HEAD)), files[0].name)
            return LogFileReader(listOf(head)) {}.read().then { read -> of(read, head.name, size / HEAD, rules) }
        }

        private fun of(head: Recording, fileName: String, times: Double, rules: RuleSet): LogNeed {
            val view = LogView.of(head).withSignals(rules.signals, fileName)
            val names = signalTopicsOf(view, rules.signals).all.map { it.topic } + RuleProgram(rules, LogShape.of(view)).topics
            val axis = listOfNotNull(view.xAxis.topic) + view.enabledTopics()
            val few = names.toSet() + axis.map { it.name }
            return LogNeed(
                PAGE + GROWTH * times * bytesOf(head.topics),
                PAGE + GROWTH * times * bytesOf(head.topics.filter { it.name in few }),
                WantedTopics(few),
            )
        }

        private fun bytesOf(topics: List<Topic>): Double =
            8.0 * (topics.sumOf { it.samples.size } + topics.mapNotNullTo(HashSet()) { it.times }.sumOf { it.size })
    }
}

/** Returns an amount of memory for people, without digits that an estimate does not have. */
internal fun memoryText(bytes: Double): String = "${(bytes / 1e7).roundToInt() * 10} MB"
