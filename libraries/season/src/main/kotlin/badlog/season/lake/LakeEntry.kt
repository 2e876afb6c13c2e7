package badlog.season.lake

import java.io.Serializable

/**
 * The records of one log in the tables of a lake.
 *
 * @property log its name in the lake.
 * @property files the files of its samples, relative to the lake.
 * @property isSalvaged whether data of the log is lost.
 */
class LakeEntry internal constructor(
    val log: String,
    internal val partition: Partition,
    val files: List<String>,
    val isSalvaged: Boolean,
    internal val records: Map<LakeTable, List<LakeRecord>>,
) : Serializable {
    /** The path of its partition in each table: the folders of season and event, with a slash between. */
    val partitionPath: String get() = partition.path

    private companion object {
        const val serialVersionUID = 1L
    }
}

/** A change to the tables of a lake. */
sealed interface LakeChange : Serializable {
    /** The path of the partition to change. */
    val partitionPath: String

    /** Adds [entry], replacing earlier records of the same log. */
    class Put(val entry: LakeEntry) : LakeChange {
        override val partitionPath: String get() = entry.partitionPath

        private companion object {
            const val serialVersionUID = 1L
        }
    }

    /** Removes the records of [log]. */
    class Remove(val log: RegisteredLog) : LakeChange {
        override val partitionPath: String get() = log.partitionPath

        private companion object {
            const val serialVersionUID = 1L
        }
    }
}
