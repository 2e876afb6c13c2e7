package badlog.season.lake

import java.io.Serializable

/**
 * What the tables of a lake hold of one log.
 *
 * @property log what the lake calls it.
 * @property files the files of its samples, seen from the lake.
 * @property isSalvaged whether the log lost something.
 */
public class LakeEntry internal constructor(
    public val log: String,
    internal val partition: Partition,
    public val files: List<String>,
    public val isSalvaged: Boolean,
    internal val records: Map<LakeTable, List<List<Any?>>>,
) : Serializable {
    /** Where its records are in each table: the folders of season and event, with a slash between. */
    public val place: String get() = partition.path

    private companion object {
        const val serialVersionUID = 1L
    }
}

/** A change to the tables of a lake. */
public sealed interface LakeChange : Serializable {
    /** In the tables of which place. */
    public val place: String

    /** [entry] is to be there, instead of what was there of that log. */
    public class Put(public val entry: LakeEntry) : LakeChange {
        override val place: String get() = entry.place

        private companion object {
            const val serialVersionUID = 1L
        }
    }

    /** [log] is not to be there any longer. */
    public class Remove(public val log: RegisteredLog) : LakeChange {
        override val place: String get() = log.place

        private companion object {
            const val serialVersionUID = 1L
        }
    }
}
