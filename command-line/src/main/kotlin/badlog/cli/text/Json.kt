package badlog.cli.text

import badlog.core.recording.Loss
import badlog.core.recording.Problem
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.descriptors.PrimitiveKind
import kotlinx.serialization.descriptors.PrimitiveSerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonEncoder
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.encodeToJsonElement
import kotlinx.serialization.json.jsonObject

/** Returns [value] as JSON; its class defines the properties for programs. */
internal inline fun <reified T> jsonOf(value: T): JsonObject = Json.encodeToJsonElement(value).jsonObject

/** A number that is written without a fraction if it has none, and as null if it is not finite. */
internal typealias JsonNumber =
    @Serializable(with = JsonNumberSerializer::class)
    Double

internal object JsonNumberSerializer : KSerializer<Double> {
    override val descriptor = PrimitiveSerialDescriptor("badlog.JsonNumber", PrimitiveKind.DOUBLE)

    override fun serialize(encoder: Encoder, value: Double) = (encoder as JsonEncoder).encodeJsonElement(elementOf(value))

    override fun deserialize(decoder: Decoder): Double = decoder.decodeDouble()

    private fun elementOf(number: Double): JsonElement = when {
        !number.isFinite() -> JsonNull
        number == Math.rint(number) && Math.abs(number) < WHOLE -> JsonPrimitive(number.toLong())
        else -> JsonPrimitive(number)
    }

    private const val WHOLE = 1e15
}

/** A [Problem], the same for every sub-command. */
@Serializable
internal class ProblemJson(
    private val kind: String,
    private val severity: String,
    private val message: String,
    private val line: Int?,
    private val topic: String?,
    private val count: Int,
    private val lost: LossJson,
) {
    constructor(problem: Problem) : this(
        problem.kind.name,
        problem.severity.name.lowercase(),
        problem.message,
        problem.line,
        problem.topic,
        problem.count,
        LossJson(problem.loss),
    )
}

/** The amount of lost data. */
@Serializable
internal class LossJson(private val rows: Int, private val cells: Int, private val bytes: Long) {
    constructor(loss: Loss) : this(loss.rows, loss.cells, loss.bytes)
}

/** A part of the x axis. */
@Serializable
internal class StretchJson(private val from: JsonNumber, private val to: JsonNumber)

internal fun json(problem: Problem): JsonElement = jsonOf(ProblemJson(problem))
