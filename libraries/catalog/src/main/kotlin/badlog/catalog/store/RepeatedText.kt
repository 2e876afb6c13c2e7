package badlog.catalog.store

import kotlinx.serialization.KSerializer
import kotlinx.serialization.descriptors.PrimitiveKind
import kotlinx.serialization.descriptors.PrimitiveSerialDescriptor
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder

/** Serializes a text that many logs share, such as the name of a topic. It is in memory only once for any number of logs. */
internal object RepeatedText : KSerializer<String> {
    override val descriptor: SerialDescriptor = PrimitiveSerialDescriptor("badlog.RepeatedText", PrimitiveKind.STRING)

    override fun serialize(encoder: Encoder, value: String) = encoder.encodeString(value)

    override fun deserialize(decoder: Decoder): String = decoder.decodeString().intern()
}
