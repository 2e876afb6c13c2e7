package badlog.core.recording

/**
 * A stream of samples with a name, a unit and attributes. It has a sample for each row of its recording, or samples at times of its own.
 *
 * @property name the full name, unique in its recording; `/` makes folders, see [PathName].
 * @property unit the unit as the file gives it; `ul` and the empty text mean none.
 * @property attributes the attributes as the file gives them, in its order.
 * @property samples one number for each row or time, NaN if there is none; of size 0 if no cell has a number. Do not change this array.
 * @property texts the cells that hold a text.
 * @property counts the number of cells of each kind.
 * @property times the time of each sample, finite and ascending, possibly repeated; in the unit of the recording's x axis, which is s if
 *   there are no rows. Null if sample `i` belongs to row `i` of the recording. Topics that were logged together share one array. Of size 0
 *   if samples were not kept. Do not change this array.
 * @property type the type of the samples as named in the file, such as `double` or `struct:Pose2d`; empty if it names none.
 * @property metadata further text about the topic in the file, often JSON; may be empty.
 * @property wasXAxis whether the topic was the x axis of the rows from which this log was made.
 * @property wasSparse whether the topic was [sparse][isSparse] in those rows, so that new rows must not repeat its last value.
 */
public class Topic(
    public val name: String,
    public val unit: String,
    public val attributes: List<String>,
    public val samples: DoubleArray,
    public val texts: TextColumn,
    public val counts: CellCounts,
    public val times: DoubleArray? = null,
    public val type: String = "",
    public val metadata: String = "",
    public val wasXAxis: Boolean = false,
    public val wasSparse: Boolean = false,
) {
    /** The number of samples, gaps included; known even if they were not kept. */
    public val size: Int get() = counts.total

    /**
     * The kind of the topic, determined by its cells. A topic of mostly texts with times of its own is a [state][TopicKind.STATE] if there
     * are few different texts or each occurs at least twice on average, otherwise [events][TopicKind.EVENT]; if the samples were not kept,
     * it is a state.
     */
    public val kind: TopicKind = kindOf(counts).let {
        if (it == TopicKind.STATE && times != null && holdsEvents(texts)) TopicKind.EVENT else it
    }

    /**
     * Whether its samples are only record sizes in bytes, because its [type] is not decoded. They are never values of the quantity in its
     * name.
     */
    public val isSizes: Boolean get() = times != null && unit == "B" && type.isNotEmpty() && type.removeSuffix("[]") !in NUMBERS

    /**
     * Whether fewer than half of the rows have a number, and on average fewer than two numbers lie between gaps. Such a topic is sampled at
     * times of its own, as in a CSV file made from a log of changes: its empty cells are not gaps, but rows without a sample.
     */
    public val isSparse: Boolean
        get() {
            if (times != null) return false
            val withoutNumber = counts.empty.toLong() + counts.texts
            val withNumber = counts.total - withoutNumber
            return withoutNumber > withNumber && withNumber < MAX_ISOLATED * counts.gaps
        }

    /** Returns this topic with some of its parts replaced. */
    public fun copy(
        name: String = this.name,
        unit: String = this.unit,
        attributes: List<String> = this.attributes,
        samples: DoubleArray = this.samples,
        texts: TextColumn = this.texts,
        counts: CellCounts = this.counts,
        times: DoubleArray? = this.times,
        type: String = this.type,
        metadata: String = this.metadata,
        wasXAxis: Boolean = this.wasXAxis,
        wasSparse: Boolean = this.wasSparse,
    ): Topic = Topic(name, unit, attributes, samples, texts, counts, times, type, metadata, wasXAxis, wasSparse)

    public companion object {
        /** The unit of a topic that has none. */
        public const val UNITLESS: String = "ul"

        /** Numbers count as isolated if, on average, at most this many are between two gaps. */
        private const val MAX_ISOLATED = 2L

        /** The types of records that are numbers. */
        private val NUMBERS = setOf("boolean", "int64", "int", "float", "double")

        /** Up to this many different texts are states, however often each occurs. */
        private const val MAX_RARE_STATES = 8

        internal fun kindOf(counts: CellCounts): TopicKind {
            val numeric = counts.numbers + counts.notFinite + counts.truthValues
            return when {
                numeric == 0 && counts.texts == 0 -> TopicKind.EMPTY
                counts.texts > numeric -> if (counts.texts * 2L >= counts.total) TopicKind.STATE else TopicKind.EVENT
                counts.truthValues == numeric -> TopicKind.BOOLEAN
                else -> TopicKind.NUMERIC
            }
        }

        private fun holdsEvents(texts: TextColumn): Boolean {
            val different = texts.dictionary.size
            return different > MAX_RARE_STATES && different * 2L > texts.size
        }
    }
}

/** The kinds of topics, by the content of their cells. */
public enum class TopicKind {
    /** No cell holds anything. */
    EMPTY,

    /** Numbers. */
    NUMERIC,

    /** Only `true` and `false`, kept as 1 and 0. */
    BOOLEAN,

    /** Mostly texts, in at least half of the rows: the states of something. */
    STATE,

    /** Mostly texts, in fewer than half of the rows: events. */
    EVENT,
}

/**
 * The number of a topic's cells for each kind of content. The first five add up to the topic's [size][Topic.size], so every cell is
 * accounted for. If topics have times of their own, a sample counts as a cell, and neighboring samples as neighboring rows.
 *
 * @property numbers finite numbers.
 * @property notFinite `NaN` and infinities that were written as such.
 * @property truthValues `true` and `false`.
 * @property texts any other text.
 * @property empty empty cells, `null`, and cells that their row lacks.
 * @property gaps the number of runs of neighboring rows without a number.
 */
public data class CellCounts(
    public val numbers: Int,
    public val notFinite: Int,
    public val truthValues: Int,
    public val texts: Int,
    public val empty: Int,
    public val gaps: Int,
) {
    /** The number of cells. */
    public val total: Int get() = numbers + notFinite + truthValues + texts + empty
}
