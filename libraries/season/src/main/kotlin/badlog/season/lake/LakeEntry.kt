package badlog.season.lake

import java.io.Serializable

/**
 * What the tables of a lake hold of one log.
 *
 * @property log what the lake calls it.
 * @property files the files of its samples, seen from the lake.
 * @property isSalvaged whether the log lost something.
 */
class LakeEntry internal constructor(
    val log: String,
    internal val partition: Partition,
    val files: List<String>,
    val isSalvaged: Boolean,
    internal val records: Map<LakeTable, List<LakeRecord>>,
) : Serializable {
    /** Where its records are in each table: the folders of season and event, with a slash between. */
    val place: String get() = partition.path

    private companion object {
        const val serialVersionUID = 1L
    }
}

/** A change to the tables of a lake. */
sealed interface LakeChange : Serializable {
    /** In the tables of which place. */
    val place: String

    /** [entry] is to be there, instead of what was there of that log. */
    class Put(val entry: LakeEntry) : LakeChange {
        override val place: String get() = entry.place

        private companion object {
            const val serialVersionUID = 1L
        }
    }

    /** [log] is not to be there any longer. */
    class Remove(val log: RegisteredLog) : LakeChange {
        override val place: String get() = log.place

        private companion object {
            const val serialVersionUID = 1L
        }
    }
}
