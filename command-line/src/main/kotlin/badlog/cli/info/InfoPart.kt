package badlog.cli.info

/** What may be shown of a log beside its summary. */
internal enum class InfoPart {
    /** A table of the topics. */
    TOPICS,

    /** Below each topic its attributes. */
    ATTRIBUTES,

    /** The values. */
    VALUES,

    /** What was wrong in the file, without notes. */
    WORST,

    /** What was wrong in the file, and what was only odd. */
    PROBLEMS,
}
