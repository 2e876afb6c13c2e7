package badlog.html

/**
 * What a page shows besides the recording itself.
 *
 * @property virtualTopics definitions of topics that are calculated from others, as `Power [W] = Voltage * Current`. The page
 *   evaluates them when it opens, and tells what is wrong with one there.
 * @property findings what rules found in the recording.
 * @property hooks what programs that looked at the recording returned, one for each program.
 */
class PageAdditions(
    val virtualTopics: List<String> = emptyList(),
    val findings: List<PageFinding> = emptyList(),
    val hooks: List<HookPart> = emptyList(),
) {
    /** Whether there is nothing, so that a page is as small as one without. */
    val isEmpty: Boolean get() = virtualTopics.isEmpty() && findings.isEmpty() && hooks.isEmpty()
}
