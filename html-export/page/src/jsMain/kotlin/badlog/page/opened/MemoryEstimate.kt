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
 * The memory that a large log needs, estimated from its beginning.
 *
 * @property bytes the bytes of memory for the whole log.
 * @property fewBytes the bytes of memory for the topics [few].
 * @property few the topics that are signals, or that rules use.
 */
internal class MemoryEstimate private constructor(val bytes: Double, val fewBytes: Double, val few: WantedTopics) {
    /** Whether this browser may have too little memory for the whole log. */
    val isTooMuch: Boolean get() = bytes > most

    companion object {
        /** The size in bytes below which files are not estimated. */
        private const val SMALL = 20e6
        private const val HEAD = 2e6

        /** The memory of the page itself, in bytes. */
        private const val PAGE = 150e6

        /** The factor by which arrays are larger than their content while they grow. */
        private const val GROWTH = 1.5

        /** The maximum memory of a page. It is a share of the device's memory. Browsers report at most 8 GB of it. */
        private val most: Double get() {
            val memory = window.navigator.asDynamic().deviceMemory as Double?
            return minOf(1.5e9, (memory ?: if (window.matchMedia("(pointer: coarse)").matches) 2.0 else 8.0) * 0.2e9)
        }

        /** Promises the estimate for the log in [files] and [rules]; null for a small log. */
        fun of(files: List<File>, rules: RuleSet): Promise<MemoryEstimate?> {
            val size = files.sumOf { it.size.toDouble() }
            if (size < SMALL) return Promise.resolve(null)
            val head = File(arrayOf(files[0].asDynamic().slice(0, HEAD)), files[0].name)
            return LogFileReader(listOf(head)) {}.read().then { read -> of(read, head.name, size / HEAD, rules) }
        }

        private fun of(head: Recording, fileName: String, times: Double, rules: RuleSet): MemoryEstimate {
            val view = LogView.of(head).withSignals(rules.signals, fileName)
            val names = signalTopicsOf(view, rules.signals).all.map { it.topic } + RuleProgram(rules, LogShape.of(view)).topics
            val axis = listOfNotNull(view.xAxis.topic) + view.enabledTopics()
            val few = names.toSet() + axis.map { it.name }
            return MemoryEstimate(
                PAGE + GROWTH * times * bytesOf(head.topics),
                PAGE + GROWTH * times * bytesOf(head.topics.filter { it.name in few }),
                WantedTopics(few),
            )
        }

        private fun bytesOf(topics: List<Topic>): Double =
            8.0 * (topics.sumOf { it.samples.size } + topics.mapNotNullTo(HashSet()) { it.times }.sumOf { it.size })
    }
}

/** Returns an amount of memory as text, rounded to 10 MB because it is an estimate. */
internal fun memoryText(bytes: Double): String = "${(bytes / 1e7).roundToInt() * 10} MB"
