package badlog.analysis

/**
 * What a topic's attribute does when a recording is shown. A program adds its own by putting an object of this kind into
 * an [AttributeRegistry].
 */
public interface Attribute {
    /** The text of the attribute, up to and without a `:`. */
    public val name: String

    /**
     * Applies it to a topic.
     *
     * @param argument what follows the `:`, or null when there is none.
     */
    public fun apply(topic: TopicPlan, argument: String?)
}
