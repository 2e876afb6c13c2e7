package badlog.catalog.store

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.expression.Quantity
import badlog.rules.Finding
import badlog.rules.standing.PROVEN_TRUST
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder

/**
 * Serializes a [Span] for a cache; the objects below do so for [Quantity] and [Finding]. Their own modules do not depend on a serialization
 * library.
 */
object SpanSerializer : KSerializer<Span> {
    @Serializable
    private class StoredSpan(val from: Double, val to: Double)

    override val descriptor: SerialDescriptor = StoredSpan.serializer().descriptor

    override fun serialize(encoder: Encoder, value: Span) =
        encoder.encodeSerializableValue(StoredSpan.serializer(), StoredSpan(value.from, value.to))

    override fun deserialize(decoder: Decoder): Span = decoder.decodeSerializableValue(StoredSpan.serializer()).let { Span(it.from, it.to) }
}

object QuantitySerializer : KSerializer<Quantity> {
    @Serializable
    private class StoredQuantity(val name: String, val value: Double, val unit: String, val time: Double)

    override val descriptor: SerialDescriptor = StoredQuantity.serializer().descriptor

    override fun serialize(encoder: Encoder, value: Quantity) =
        encoder.encodeSerializableValue(StoredQuantity.serializer(), StoredQuantity(value.name, value.value, value.unit, value.time))

    override fun deserialize(decoder: Decoder): Quantity =
        decoder.decodeSerializableValue(StoredQuantity.serializer()).let { Quantity(it.name, it.value, it.unit, it.time) }
}

object FindingSerializer : KSerializer<Finding> {
    @Serializable
    private class StoredFinding(
        val rule: String,
        val severity: Severity,
        val topic: String?,
        val text: String,
        val time: Double,
        val spans: List<
            @Serializable(with = SpanSerializer::class)
            Span,
            >,
        val spanCount: Int,
        val timeUnit: String,
        val isOfHook: Boolean,
        val evidence: List<String>,
        val next: String,
        val caveats: List<String>,
        val isForEach: Boolean,
        val trust: Double = PROVEN_TRUST,
        val meanwhile: List<String> = emptyList(),
    )

    override val descriptor: SerialDescriptor = StoredFinding.serializer().descriptor

    override fun serialize(encoder: Encoder, value: Finding) = encoder.encodeSerializableValue(
        StoredFinding.serializer(),
        value.run {
            StoredFinding(
                rule, severity, topic, text, time, spans, spanCount, timeUnit, isOfHook, evidence, next, caveats, isForEach, trust,
                meanwhile,
            )
        },
    )

    override fun deserialize(decoder: Decoder): Finding = decoder.decodeSerializableValue(StoredFinding.serializer()).run {
        Finding(
            rule,
            severity,
            topic,
            text,
            time,
            spans,
            spanCount,
            timeUnit,
            isOfHook,
            evidence,
            next,
            caveats = caveats,
            isForEach = isForEach,
            trust = trust,
            meanwhile = meanwhile,
        )
    }
}
