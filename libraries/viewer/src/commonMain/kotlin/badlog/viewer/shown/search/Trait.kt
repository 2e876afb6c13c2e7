package badlog.viewer.shown.search

/**
 * A property of a topic that a search can use besides the name.
 *
 * @property word the word for it in a search.
 */
enum class Trait(val word: String) {
    /** The values are states, or true and false. */
    STATE("is:state"),

    /** The values are numbers. */
    NUMBER("is:number"),

    /** The values are texts about what happened. */
    EVENT("is:event"),

    /** The topic never changes. */
    CONSTANT("is:constant"),

    /** The topic has no logged values. */
    EMPTY("is:empty"),

    /** A finding is about the topic. */
    FINDING("has:finding"),
    ;

    companion object {
        private val BY_WORD = entries.associateBy { it.word }

        /** Returns the trait that [word], in lower case, stands for; null for an ordinary word. */
        fun of(word: String): Trait? = BY_WORD[word]
    }
}
