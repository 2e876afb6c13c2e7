package badlog.season.lake

import java.io.Serializable

/** A record of a [LakeTable]: a value for each of its fields, in their order and of their types. Only the table creates it. */
internal class LakeRecord(private val values: List<Any?>) : Serializable {
    /** Returns the value of the field at [index]. */
    operator fun get(index: Int): Any? = values[index]
}

/** A record with its partition. */
internal class PlacedRecord(val partition: Partition, val record: LakeRecord)

private const val serialVersionUID = 1L
