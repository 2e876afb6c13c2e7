package badlog.catalog.store

import badlog.core.analysis.SeriesStatistics
import badlog.core.recording.TopicKind
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.ProblemCounts
import badlog.viewer.catalog.TopicSummary
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder

/** Serializes a [LogSummary] for a cache. It is separate because the page also uses [LogSummary], but has no serialization library. */
internal object SummarySerializer : KSerializer<LogSummary> {
    override val descriptor: SerialDescriptor = StoredSummary.serializer().descriptor

    override fun serialize(encoder: Encoder, value: LogSummary) =
        encoder.encodeSerializableValue(StoredSummary.serializer(), StoredSummary.of(value))

    override fun deserialize(decoder: Decoder): LogSummary = try {
        decoder.decodeSerializableValue(StoredSummary.serializer()).summary()
    } catch (e: IllegalArgumentException) {
        throw SerializationException(e)
    }
}

@Serializable
private class StoredSummary(
    val event: String?,
    val type: String?,
    val number: String?,
    val alliance: String?,
    val second: Long,
    val source: DateSource,
    val duration: Double?,
    val xUnit: String,
    val samples: Long,
    val errors: Int,
    val warnings: Int,
    val notes: Int,
    val content: Content,
    val trouble: String?,
    val battery: StoredBattery?,
    val topics: List<StoredTopic>,
) {
    fun summary() = LogSummary(
        MatchOfLog(event, type, number, alliance),
        // Only years with four digits can be written as a date.
        LogDate(second.also { require(it in PLAUSIBLE) { "no date: $it" } }, source),
        duration,
        xUnit,
        samples,
        ProblemCounts(errors, warnings, notes),
        content,
        trouble,
        battery?.use(),
        topics.map { it.topic() },
    )

    companion object {
        private val PLAUSIBLE = -62_000_000_000L..250_000_000_000L

        fun of(summary: LogSummary): StoredSummary = with(summary) {
            StoredSummary(
                match.event,
                match.type,
                match.number,
                match.alliance,
                date.second,
                date.source,
                duration,
                xUnit,
                samples,
                problems.errors,
                problems.warnings,
                problems.notes,
                content,
                trouble,
                battery?.let { StoredBattery.of(it) },
                topics.map { StoredTopic.of(it) },
            )
        }
    }
}

@Serializable
private class StoredTopic(
    @Serializable(with = RepeatedText::class) val name: String,
    @Serializable(with = RepeatedText::class) val unit: String,
    val kind: TopicKind,
    val count: Int,
    val gaps: Int,
    val min: Double,
    val max: Double,
    val mean: Double,
    val standardDeviation: Double,
    val percentile5: Double,
    val median: Double,
    val percentile95: Double,
    val first: Double,
    val last: Double,
    val integral: Double,
    val preview: ByteArray,
) {
    fun topic() = TopicSummary(
        name,
        unit,
        kind,
        SeriesStatistics(
            count,
            gaps,
            min,
            max,
            mean,
            standardDeviation,
            percentile5,
            median,
            percentile95,
            first,
            last,
            integral,
        ),
        PreviewLine(preview),
    )

    companion object {
        fun of(topic: TopicSummary): StoredTopic = with(topic.statistics) {
            StoredTopic(
                topic.name,
                topic.unit,
                topic.kind,
                count,
                gaps,
                min,
                max,
                mean,
                standardDeviation,
                percentile5,
                median,
                percentile95,
                first,
                last,
                integral,
                topic.preview.bytes,
            )
        }
    }
}
