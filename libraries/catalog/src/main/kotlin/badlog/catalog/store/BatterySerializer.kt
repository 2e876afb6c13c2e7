package badlog.catalog.store

import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import kotlinx.serialization.KSerializer
import kotlinx.serialization.Serializable
import kotlinx.serialization.descriptors.SerialDescriptor
import kotlinx.serialization.encoding.Decoder
import kotlinx.serialization.encoding.Encoder

/**
 * The serializer of a [BatteryUse] for caches. The class itself is not serializable, because the page uses it without a serialization
 * library.
 */
internal object BatterySerializer : KSerializer<BatteryUse> {
    override val descriptor: SerialDescriptor = StoredBattery.serializer().descriptor

    override fun serialize(encoder: Encoder, value: BatteryUse) =
        encoder.encodeSerializableValue(StoredBattery.serializer(), StoredBattery.of(value))

    override fun deserialize(decoder: Decoder): BatteryUse = decoder.decodeSerializableValue(StoredBattery.serializer()).use()
}

@Serializable
internal class StoredBattery(
    val name: String?,
    val topic: String?,
    val lowest: Double?,
    val restBefore: Double?,
    val restAfter: Double?,
    val energy: Double?,
    val milliohms: Double?,
    val uncertainty: Double?,
    val isBrownedOut: Boolean = false,
) {
    fun use() = BatteryUse(
        name,
        topic,
        lowest,
        restBefore,
        restAfter,
        energy,
        if (milliohms == null || uncertainty == null) null else Resistance(milliohms, uncertainty),
        isBrownedOut,
    )

    companion object {
        fun of(use: BatteryUse): StoredBattery = with(use) {
            StoredBattery(name, topic, lowest, restBefore, restAfter, energy, resistance?.milliohms, resistance?.uncertainty, isBrownedOut)
        }
    }
}
