// Generated from the OpenAPI document by `npm run api-types`: change the server's schemas instead.
export interface paths {
    "/api/v1/sessions/{token}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Session
         * @description The study, this participant's steps in order, the answers so far and where to go on.
         */
        get: operations["show_session"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sessions/{token}/responses": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Record Response
         * @description Store one answer. Acknowledged only once it is on the disk; safe to send again.
         */
        post: operations["record_response"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sessions/{token}/steps/{index}/motion": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Show Motion
         * @description The motion that the sliders make, in a step that matches a target and whose turn it is.
         */
        post: operations["show_motion"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sessions/{token}/complete": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Complete
         * @description Close the session once every step has an answer, and give the completion code.
         */
        post: operations["complete"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Clips
         * @description The clips: samples for everybody, the others for researchers and their API keys.
         */
        get: operations["list_clips"];
        put?: never;
        /**
         * Create Clip
         * @description Make a clip by a recipe and keep it: 201.
         *
         *     The same recipe on the same source gives the same clip; 200 if it is there already, under the
         *     name and the tags that it has.
         */
        post: operations["create_clip"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Clip As Json
         * @description The clip as a JSON file, its motion in metres, seconds and quaternions w, x, y, z.
         */
        get: operations["clip_as_json"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}.glb": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Clip As Glb
         * @description The clip as a GLB file, with its figure.
         */
        get: operations["clip_as_glb"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}.bvh": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Clip As Bvh
         * @description The clip as a BVH file, in centimetres.
         */
        get: operations["clip_as_bvh"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Clip
         * @description The clip as `Accept` wants it: JSON, GLB or BVH. The same with `.json`, `.glb`, `.bvh`.
         */
        get: operations["show_clip"];
        put?: never;
        post?: never;
        /**
         * Delete Clip
         * @description Delete an imported or edited clip that nothing else needs.
         */
        delete: operations["delete_clip"];
        options?: never;
        head?: never;
        /**
         * Correct Clip
         * @description Read the clip's file again with corrections. The clip gets another id.
         */
        patch: operations["correct_clip"];
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/confirm": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Confirm Clip
         * @description Keep an imported clip as its report describes it.
         */
        post: operations["confirm_clip"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/label": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Label Clip
         * @description Give an imported or edited clip another name, and other tags if any are given.
         */
        put: operations["label_clip"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Preview Clip
         * @description The edited clip as GLB without a figure. Nothing is stored.
         */
        post: operations["preview_clip"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/check": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Check Clip
         * @description What an edit would break, and when its feet would stand. Nothing is stored.
         */
        post: operations["check_clip"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/ease-off": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Ease Off Clip
         * @description The recipe, lowered as little as needed for a report without findings. Nothing is stored.
         */
        post: operations["ease_off_clip"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/quality": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Clip Quality
         * @description What the edit of a kept clip broke; the clip's JSON tells it from then on.
         */
        get: operations["clip_quality"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/rebuild": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Rebuild Clip
         * @description Make an edited clip again from its recipe and compare the two motions bit by bit.
         *
         *     If the engine is a newer one, the clip that it makes is kept beside the old one.
         */
        post: operations["rebuild_clip"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/skeletons": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Skeletons
         * @description The skeletons that clips of the library share, each with an example.
         */
        get: operations["list_skeletons"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/retargeting": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Clip Retargeting
         * @description How well a clip's motion would fit another skeleton. Nothing is stored.
         *
         *     The recipe `[{"operation": "retarget@1", "parameters": {"clip": "<onto>"}}]` makes the clip;
         *     for one cycle, `cycle@1` stands before it, with the whole motion's start and end if it is one.
         */
        get: operations["clip_retargeting"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/operations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Operations
         * @description Everything that a recipe's steps can do: units, ranges and defaults as JSON Schema.
         */
        get: operations["list_operations"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/operations/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Operation
         * @description One operation, by name and version: `grid@1`.
         */
        get: operations["show_operation"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/presets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Presets
         * @description The recipes that come with the server, each with the emotion that it is meant to show.
         */
        get: operations["list_presets"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/poses": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Poses
         * @description The poses that posture offsets can be made of: stances, then those captured from clips.
         */
        get: operations["list_poses"];
        put?: never;
        /**
         * Capture Pose
         * @description Keep the pose of one frame of a clip. The same pose again only changes its name.
         */
        post: operations["capture_pose"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/poses/{pose_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /**
         * Delete Pose
         * @description Delete a captured pose that no clip was made with.
         */
        delete: operations["delete_pose"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/graphs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Graphs
         * @description All motion graphs, the sample first.
         */
        get: operations["list_graphs"];
        put?: never;
        /**
         * Create Graph
         * @description Keep a graph of clips that have one skeleton and one frame rate.
         */
        post: operations["create_graph"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/graphs/preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Preview Graph
         * @description The transitions that a graph would have. Nothing is stored.
         */
        post: operations["preview_graph"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/graphs/{graph_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Graph
         * @description A graph with its transitions; the sample's id is `sample`.
         */
        get: operations["show_graph"];
        /**
         * Change Graph
         * @description Put a graph in the place of one that is there; the sample cannot be changed.
         */
        put: operations["change_graph"];
        post?: never;
        /**
         * Delete Graph
         * @description Delete a graph; its clips stay.
         */
        delete: operations["delete_graph"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/graphs/{graph_id}/play": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Play Graph
         * @description The next piece of a walk through the graph.
         *
         *     The server remembers nothing: what it gives back as `after` is the place of the next request.
         */
        post: operations["play_graph"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/imports": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Import Motion
         * @description Read a BVH file; its clip then waits to be confirmed.
         *
         *     201 for a new clip, 200 when the same motion is in the library already.
         */
        post: operations["import_motion"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/live": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Live
         * @description How a study is going: who stands where, where they leave, who is suspicious and why.
         */
        get: operations["read_live"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/audit": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Audit
         * @description Who did what with the study, the newest first; `before` is the `older` of the last page.
         */
        get: operations["read_audit"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/sessions/{session_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Session
         * @description One participant's way through the study: order, answers, times.
         */
        get: operations["read_session"];
        put?: never;
        post?: never;
        /**
         * Delete Session
         * @description Delete a participant's answers and all that is known of them, for good.
         */
        delete: operations["delete_session"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/sessions/{session_id}/export.json": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Export Session
         * @description All that is stored of one participant, to hand out to the person. It is written down.
         */
        get: operations["export_session"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/sessions/{session_id}/exclude": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Exclude Session
         * @description Leave a participant out of results and groups. The answers stay; it can be taken back.
         */
        post: operations["exclude_session"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/sessions/{session_id}/include": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Include Session
         * @description Count a participant again.
         */
        post: operations["include_session"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/sessions/{session_id}/flag": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Flag Session
         * @description Mark a participant to be looked at again. It changes nothing else.
         */
        post: operations["flag_session"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/sessions/{session_id}/unflag": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Unflag Session
         * @description Take the mark off a participant.
         */
        post: operations["unflag_session"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/members": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Members
         * @description Who works on the study, as what.
         */
        get: operations["list_members"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/members/{email}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Put Member
         * @description Add a researcher of this server by address, or change what a member may do.
         */
        put: operations["put_member"];
        post?: never;
        /**
         * Remove Member
         * @description Take a member out of the study; who is no owner only themselves.
         */
        delete: operations["remove_member"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/results": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Results
         * @description All numbers of the results page, of one part; without its name of the first.
         */
        get: operations["read_results"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/impressions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Impressions
         * @description Which pairs of adjectives say something, and which of them go together.
         *
         *     Thresholds and cut that are given stand in for the saved ones; nothing is stored.
         */
        get: operations["read_impressions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/impressions/{part}/stability": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Draw Stability
         * @description How the analysis would differ with other participants: a bootstrap, the same by seed.
         *
         *     A large one becomes a job (202), whose address is in `Location`; its result is at
         *     `stability/{job}` once it is done.
         */
        post: operations["draw_stability"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/impressions/{part}/stability/{job}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Read Stability
         * @description What a large bootstrap has found.
         */
        get: operations["read_stability"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/impressions/{part}/comparison": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Compare Impressions
         * @description The clusters of two studies side by side: how far they agree, which pairs moved.
         */
        get: operations["compare_impressions"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/impressions/{part}/comparable": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Comparable
         * @description The parts of your studies that this one can be compared with.
         */
        get: operations["list_comparable"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/impressions/{part}/space": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Freeze Impressions
         * @description Make an authoring space of the saved analysis, as the next version of its name.
         */
        post: operations["freeze_impressions"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/impressions/{part}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Choose Impressions
         * @description Save thresholds, cut, names and moves by hand. What changed is written down.
         *
         *     With `seen`, choices that somebody else saved since then are not written over.
         */
        put: operations["choose_impressions"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Studies
         * @description Every study that the caller may see, with its state and counts.
         */
        get: operations["list_studies"];
        put?: never;
        /**
         * Create Study
         * @description Make a study: from a template, a definition, a study file, or with nothing in it.
         *
         *     It begins as a draft that only its members see. Its address is the definition's `slug`, with a
         *     number added where that is taken.
         */
        post: operations["create_study"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Study
         * @description A study: its draft and what is wrong with it, its versions, and how it is run.
         */
        get: operations["show_study"];
        put?: never;
        post?: never;
        /**
         * Delete Study
         * @description Delete a study that was never published.
         */
        delete: operations["delete_study"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/draft": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Save Draft
         * @description Keep a draft, whatever is still wrong with it; the answer tells what is.
         *
         *     With `seen`, a draft that somebody else saved since then is not written over.
         */
        put: operations["save_draft"];
        post?: never;
        /**
         * Discard Draft
         * @description Go back to the newest version.
         */
        delete: operations["discard_draft"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/draft/clips": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Add Clips
         * @description Give a part of the draft more clips; those that it has already are not added again.
         *
         *     Nothing changes for participants until the draft is published.
         */
        post: operations["add_clips"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/changes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Changes
         * @description What publishing the draft would change, in sentences, and the hash that it would have.
         */
        get: operations["show_changes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/publish": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Publish Study
         * @description Freeze the draft as the next version, which new participants see from then on.
         *
         *     A draft without changes makes no version. The first version opens the study.
         */
        post: operations["publish_study"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/running": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        /**
         * Change Running
         * @description Change who may come and when, and where participants go at the end.
         */
        put: operations["change_running"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/state": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Change State
         * @description Open, pause or close a study. Who has begun can go on.
         */
        post: operations["change_state"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/duplicate": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Duplicate Study
         * @description Make another study with the same content, owned by the caller.
         */
        post: operations["duplicate_study"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/invitations": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Make Invitations
         * @description Make personal links, one participant each. The same label gives the same link again.
         */
        post: operations["make_invitations"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/file": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Download Study File
         * @description A version as a study file; without a number, what is being edited.
         */
        get: operations["download_study_file"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/preview": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Preview Study
         * @description A participant's whole way through what is being edited. Nothing is stored or counted.
         */
        get: operations["preview_study"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/studies/{slug}/preview/steps/{index}/motion": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Preview Motion
         * @description The motion that the sliders of a preview's step make; `part` as the preview was asked for.
         */
        post: operations["preview_motion"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/study-templates": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Study Templates
         * @description The studies that come with the server to begin with.
         */
        get: operations["list_study_templates"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/study-drafts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Study Drafts
         * @description What is being edited of every study that the caller may change: which parts take clips.
         */
        get: operations["list_study_drafts"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/batch": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Create Batch
         * @description Make up to 2000 clips. All are checked first; then a job makes them one after the other.
         *
         *     Ask for the job, whose address is in `Location`, to see how far it is. Clips that are in the
         *     library already are not made again. A job outlives a restart of the server.
         */
        post: operations["create_batch"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/batch/plan": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Plan Batch
         * @description The clips that sources by presets come to, with names and tags. Nothing is made.
         */
        post: operations["plan_batch"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sets/foerger": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Plan Foerger
         * @description Förger's twenty modified clips, from the sample library's two neutral ones.
         */
        get: operations["plan_foerger"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Jobs
         * @description The last fifty jobs, the newest first.
         */
        get: operations["list_jobs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{job_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Job
         * @description How far a job is, and what became of each of its clips.
         */
        get: operations["show_job"];
        put?: never;
        post?: never;
        /**
         * Cancel Job
         * @description Stop a job. What it has made stays; one that has ended stays as it is.
         */
        delete: operations["cancel_job"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * List Spaces
         * @description All authoring spaces, newest first.
         */
        get: operations["list_spaces"];
        put?: never;
        /**
         * Create Space
         * @description Make a space of clips that nobody judged; its sliders are motion features.
         *
         *     The clips have one skeleton, and all of them are cycles or none.
         */
        post: operations["create_space"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces/{space_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Show Space
         * @description A space with all its numbers.
         */
        get: operations["show_space"];
        put?: never;
        post?: never;
        /**
         * Delete Space
         * @description Delete a space that no study needs. Its clips stay, and so do clips that were made in it.
         */
        delete: operations["delete_space"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces/{space_id}/weights": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Weigh Point
         * @description The examples' weights at a point. Nothing is stored.
         */
        post: operations["weigh_point"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces/{space_id}/motion": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Move Point
         * @description The motion at a point as GLB without a figure. Nothing is stored.
         */
        post: operations["move_point"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces/{space_id}/recipe": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Write Recipe
         * @description A point as a recipe: `POST /api/v1/clips` makes the clip, which then needs no space.
         */
        post: operations["write_recipe"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces/{space_id}/versions": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Create Space Version
         * @description Make the next version, with other keytimes or with clips that nobody judged.
         *
         *     The impressions of joining clips are predicted from their motion. Pairs that cannot be
         *     predicted are left out of the new version, and its note says so.
         */
        post: operations["create_space_version"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces/{space_id}/predictions/{clip_id}": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Predict Clip
         * @description The impressions that a clip would have in a space, predicted from its motion.
         */
        get: operations["predict_clip"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/spaces/{space_id}/targets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Draw Targets
         * @description Motions to be matched: far from each other, and the same for the same seed.
         */
        post: operations["draw_targets"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/clips/{clip_id}/keytimes": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Clip Keytimes
         * @description When a clip's feet strike and leave the floor; nothing for one that is no cycle.
         */
        get: operations["clip_keytimes"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        /**
         * Agreement
         * @description Adjusted Rand index: the mean of the samples, and where the middle 95 % of them lie.
         */
        Agreement: {
            /** Mean */
            mean: number;
            /** Low */
            low: number;
            /** High */
            high: number;
        };
        /**
         * AnalysisChoices
         * @description What a researcher chose in the analysis of a part.
         *
         *     Attributes:
         *         least_peak, most_spread: a pair is dropped if its μ* is below or its σ̄ above. The defaults
         *             are for answers from −2 to 2 and grow with the reach of others.
         *         clusters: into how many Ward's tree is cut.
         *         names: of the clusters, by the id of the pair that stands first in each.
         *         moved: pair to a pair that the tree put into the cluster that it was moved into by hand.
         * @example {
         *       "clusters": 4,
         *       "least_peak": 1,
         *       "most_spread": 0.85,
         *       "moved": {
         *         "tight_free": "calm_excited"
         *       },
         *       "names": {
         *         "small_large": "size"
         *       }
         *     }
         */
        AnalysisChoices: {
            /**
             * Least Peak
             * @default 1
             */
            least_peak: number;
            /**
             * Most Spread
             * @default 0.85
             */
            most_spread: number;
            /**
             * Clusters
             * @default 4
             */
            clusters: number;
            /**
             * Names
             * @default {}
             */
            names: {
                [key: string]: string;
            };
            /**
             * Moved
             * @default {}
             */
            moved: {
                [key: string]: string;
            };
        };
        /**
         * Answer
         * @description The answer to one step, as the page sends it; a page without a question sends none.
         *
         *     Attributes:
         *         revision: 1 for the first answer, one more for each change after going back.
         *         answers: what was chosen; `app.schemas.study.tasks` says what for each kind of trial. A form
         *             sends each field's text, number, option or list of options.
         *         touched: what was set by hand; the others kept what was preselected.
         *         rt_ms: from the trial's start to the answer; time_elapsed_ms: from the session page's.
         *         client_time: the browser's clock.
         */
        Answer: {
            /** Trial Index */
            trial_index: number;
            /** Revision */
            revision: number;
            /** Answers */
            answers: {
                [key: string]: number | string | string[];
            };
            /** Touched */
            touched: string[];
            /**
             * Comment
             * @default
             */
            comment: string;
            /** Rt Ms */
            rt_ms: number;
            /** Time Elapsed Ms */
            time_elapsed_ms: number;
            /**
             * Client Time
             * Format: date-time
             */
            client_time: string;
            record: components["schemas"]["ViewingRecord"];
        };
        /**
         * AnswerReceipt
         * @description The answer is durably stored.
         *
         *     Attributes:
         *         state: no longer `active` where the answer has ended the study: the page goes to its thanks.
         */
        AnswerReceipt: {
            /** Trial Index */
            trial_index: number;
            /** Revision */
            revision: number;
            /**
             * Received At
             * Format: date-time
             */
            received_at: string;
            /**
             * State
             * @default active
             * @enum {string}
             */
            state: "active" | "complete" | "screened_out" | "failed_attention" | "withdrawn";
        };
        /**
         * AskingPart
         * @description A part of a study that asks about clips.
         *
         *     Attributes:
         *         task: the kind of its question.
         *         clips: how many it has.
         */
        AskingPart: {
            /** Id */
            id: string;
            /** Task */
            task: string;
            /** Clips */
            clips: number;
        };
        /**
         * AuditLine
         * @description One thing that somebody did with a study.
         */
        AuditLine: {
            /** Id */
            id: number;
            /**
             * At
             * Format: date-time
             */
            at: string;
            /** Who */
            who: string;
            /** Act */
            act: string;
            /** Sentence */
            sentence: string;
            /** Session Id */
            session_id: string | null;
        };
        /**
         * AuditTrail
         * @description A page of the audit trail, the newest first; `older`, where there is more, asks for it.
         */
        AuditTrail: {
            /** Entries */
            entries: components["schemas"]["AuditLine"][];
            /** Older */
            older: number | null;
        };
        /**
         * Axis
         * @description All clips on one axis, in the study's order.
         *
         *     Attributes:
         *         title: what was asked, in few words.
         *         left, right: the words at its ends.
         *         bipolar: whether its middle is neither the one nor the other.
         *         lowest, highest: the ends as numbers; steps: the words over the steps, none on a slider.
         */
        Axis: {
            /** Id */
            id: string;
            /** Title */
            title: string;
            /** Left */
            left: string;
            /** Right */
            right: string;
            /** Bipolar */
            bipolar: boolean;
            /** Lowest */
            lowest: number;
            /** Highest */
            highest: number;
            /** Steps */
            steps: string[];
            /** Cells */
            cells: components["schemas"]["Cell"][];
            /** Sentence */
            sentence: string;
        };
        /**
         * Batch
         * @description Clips to make: each one by itself, or sources by presets.
         * @example {
         *       "presets": [
         *         "sad",
         *         "angry"
         *       ],
         *       "sources": [
         *         "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
         *       ],
         *       "tags": {
         *         "set": "pilot"
         *       }
         *     }
         */
        Batch: {
            /** Items */
            items?: components["schemas"]["ClipRequest"][] | null;
            /** Sources */
            sources?: string[] | null;
            /** Presets */
            presets?: string[] | null;
            /**
             * Tags
             * @default {}
             */
            tags: {
                [key: string]: string;
            };
        };
        /** Body_import_motion */
        Body_import_motion: {
            /**
             * File
             * @description A BVH file
             */
            file: string;
            /**
             * Options
             * @description ImportOptions as JSON
             * @default {}
             */
            options: string;
        };
        /**
         * ByParticipants
         * @description How like the solution of all one from so many participants is.
         *
         *     Attributes:
         *         whole, shared: as in `Stability`.
         *         kept_alike: mean share of pairs that are kept, or left out, as by all participants.
         */
        ByParticipants: {
            /** Participants */
            participants: number;
            whole: components["schemas"]["Agreement"];
            shared: components["schemas"]["Agreement"] | null;
            /** Kept Alike */
            kept_alike: number;
        };
        /**
         * Cell
         * @description One clip on one axis.
         *
         *     Attributes:
         *         n: participants.
         *         mean: on a bipolar axis, the right pole is positive; low, high: t-based 95 % interval.
         *         shares: part of the answers at each step from left to right, in 0 ... 1; null where the
         *             answers have no steps.
         */
        Cell: {
            /** Clip */
            clip: string;
            /** N */
            n: number;
            /** Mean */
            mean: number | null;
            /** Sd */
            sd: number | null;
            /** Low */
            low: number | null;
            /** High */
            high: number | null;
            /** Shares */
            shares: number[] | null;
        };
        /**
         * Changes
         * @description What publishing would change.
         *
         *     Attributes:
         *         number, hash: those of the version that it would make.
         *         same: nothing is new, and no version would be made.
         */
        Changes: {
            /** Number */
            number: number;
            /** Hash */
            hash: string;
            /** Same */
            same: boolean;
            /** Changes */
            changes: string[];
        };
        /**
         * Checked
         * @description What an edit would give: its report, when its feet stand, duration (s) and frames.
         */
        Checked: {
            /** Recipe Hash */
            recipe_hash: string;
            report: components["schemas"]["QualityReport"];
            contacts: components["schemas"]["Contacts"];
            /** Duration */
            duration: number;
            /** Frames */
            frames: number;
        };
        /**
         * Choice
         * @description Every one of the sources by every one of the presets, with tags that all get.
         * @example {
         *       "presets": [
         *         "sad",
         *         "angry"
         *       ],
         *       "sources": [
         *         "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
         *       ],
         *       "tags": {
         *         "set": "pilot"
         *       }
         *     }
         */
        Choice: {
            /** Sources */
            sources: string[];
            /** Presets */
            presets: string[];
            /**
             * Tags
             * @default {}
             */
            tags: {
                [key: string]: string;
            };
        };
        /**
         * Choices
         * @description What was chosen; of `correct`, how often the choice was right. `chance`: by guessing.
         */
        Choices: {
            /**
             * Id
             * @enum {string}
             */
            id: "choice" | "correct";
            /** Title */
            title: string;
            /** Chance */
            chance: number | null;
            /** Rows */
            rows: components["schemas"]["Share"][];
            /** Sentence */
            sentence: string;
        };
        /**
         * Clip
         * @description A clip of the study.
         */
        Clip: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /** Label */
            label: string;
            /** Body */
            body: string;
            /** Style */
            style: string;
        };
        /**
         * ClipCount
         * @description How often a clip was judged, practice and attention checks left out.
         */
        ClipCount: {
            /** Clip */
            clip: string;
            /** Label */
            label: string;
            /** Complete */
            complete: number;
            /** Others */
            others: number;
        };
        /**
         * ClipDetail
         * @description A clip with the report of its import, or with what it is made of.
         *
         *     Attributes:
         *         provenance: of an edited clip.
         *         quality: of an edited clip, once somebody has asked for it.
         * @example {
         *       "cyclic": true,
         *       "duration": 1.6,
         *       "figure_url": "/media/7d793037a0760186574b0282f2f435e77d793037a0760186574b0282f2f435e7.glb",
         *       "frame_time": 0.0333333,
         *       "frames": 49,
         *       "glb_url": "/media/5d41402abc4b2a76b9719d911017c5925d41402abc4b2a76b9719d911017c592.glb",
         *       "id": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "name": "set_b_sad_slow",
         *       "page_url": "/library/0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "poster_time": 0.8,
         *       "skeleton_hash": "c1d2a6f0b3e94787a5f60d1e2b3c4d5e6f708192a3b4c5d6e7f8091a2b3c4d5e",
         *       "source": "sample",
         *       "state": "kept",
         *       "stature": 1.74,
         *       "tags": {
         *         "body": "adult",
         *         "emotion": "sad",
         *         "set": "B",
         *         "speed": "slow",
         *         "synthetic": "yes"
         *       }
         *     }
         */
        ClipDetail: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /**
             * Source
             * @enum {string}
             */
            source: "sample" | "imported" | "edited";
            /**
             * State
             * @enum {string}
             */
            state: "kept" | "to_confirm" | "retired";
            /** Tags */
            tags: {
                [key: string]: string;
            };
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Duration */
            duration: number;
            /** Cyclic */
            cyclic: boolean;
            /** Stature */
            stature: number;
            /** Poster Time */
            poster_time: number;
            /** Skeleton Hash */
            skeleton_hash: string;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Page Url */
            page_url: string;
            /** Recipe Source */
            recipe_source: string | null;
            /** Variant Of */
            variant_of: string | null;
            report: components["schemas"]["ImportReport"] | null;
            provenance: components["schemas"]["Provenance"] | null;
            quality: components["schemas"]["QualityReport"] | null;
        };
        /**
         * ClipDocument
         * @description A clip with its motion, which ``?motion=false`` leaves out.
         * @example {
         *       "cyclic": true,
         *       "duration": 1.6,
         *       "figure_url": "/media/7d793037a0760186574b0282f2f435e77d793037a0760186574b0282f2f435e7.glb",
         *       "frame_time": 0.0333333,
         *       "frames": 49,
         *       "glb_url": "/media/5d41402abc4b2a76b9719d911017c5925d41402abc4b2a76b9719d911017c592.glb",
         *       "id": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "name": "set_b_sad_slow",
         *       "page_url": "/library/0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "poster_time": 0.8,
         *       "skeleton_hash": "c1d2a6f0b3e94787a5f60d1e2b3c4d5e6f708192a3b4c5d6e7f8091a2b3c4d5e",
         *       "source": "sample",
         *       "state": "kept",
         *       "stature": 1.74,
         *       "tags": {
         *         "body": "adult",
         *         "emotion": "sad",
         *         "set": "B",
         *         "speed": "slow",
         *         "synthetic": "yes"
         *       }
         *     }
         */
        ClipDocument: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /**
             * Source
             * @enum {string}
             */
            source: "sample" | "imported" | "edited";
            /**
             * State
             * @enum {string}
             */
            state: "kept" | "to_confirm" | "retired";
            /** Tags */
            tags: {
                [key: string]: string;
            };
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Duration */
            duration: number;
            /** Cyclic */
            cyclic: boolean;
            /** Stature */
            stature: number;
            /** Poster Time */
            poster_time: number;
            /** Skeleton Hash */
            skeleton_hash: string;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Page Url */
            page_url: string;
            /** Recipe Source */
            recipe_source: string | null;
            /** Variant Of */
            variant_of: string | null;
            report: components["schemas"]["ImportReport"] | null;
            provenance: components["schemas"]["Provenance"] | null;
            quality: components["schemas"]["QualityReport"] | null;
            motion?: components["schemas"]["Motion"] | null;
        };
        /**
         * ClipList
         * @description The library.
         */
        ClipList: {
            /** Clips */
            clips: components["schemas"]["ClipView"][];
        };
        /**
         * ClipRequest
         * @description An edit to keep as a clip. Without a name it is called after its source.
         * @example {
         *       "name": "walk_sad",
         *       "preset": "sad",
         *       "source": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "tags": {
         *         "emotion": "sad",
         *         "made": "modified"
         *       }
         *     }
         */
        ClipRequest: {
            /** Source */
            source: string;
            /** Operations */
            operations?: components["schemas"]["Step"][] | null;
            /** Preset */
            preset?: string | null;
            /** Name */
            name?: string | null;
            /**
             * Tags
             * @default {}
             */
            tags: {
                [key: string]: string;
            };
        };
        /**
         * ClipView
         * @description A clip of the library; times in seconds, stature in metres.
         *
         *     Attributes:
         *         skeleton_hash: the same for all clips that move one skeleton.
         *         recipe_source: id of the clip that its recipe begins with; variant_of: the same, unless the
         *             recipe makes something else of it: a motion on another body, or a mix of several.
         * @example {
         *       "cyclic": true,
         *       "duration": 1.6,
         *       "figure_url": "/media/7d793037a0760186574b0282f2f435e77d793037a0760186574b0282f2f435e7.glb",
         *       "frame_time": 0.0333333,
         *       "frames": 49,
         *       "glb_url": "/media/5d41402abc4b2a76b9719d911017c5925d41402abc4b2a76b9719d911017c592.glb",
         *       "id": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "name": "set_b_sad_slow",
         *       "page_url": "/library/0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "poster_time": 0.8,
         *       "skeleton_hash": "c1d2a6f0b3e94787a5f60d1e2b3c4d5e6f708192a3b4c5d6e7f8091a2b3c4d5e",
         *       "source": "sample",
         *       "state": "kept",
         *       "stature": 1.74,
         *       "tags": {
         *         "body": "adult",
         *         "emotion": "sad",
         *         "set": "B",
         *         "speed": "slow",
         *         "synthetic": "yes"
         *       }
         *     }
         */
        ClipView: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /**
             * Source
             * @enum {string}
             */
            source: "sample" | "imported" | "edited";
            /**
             * State
             * @enum {string}
             */
            state: "kept" | "to_confirm" | "retired";
            /** Tags */
            tags: {
                [key: string]: string;
            };
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Duration */
            duration: number;
            /** Cyclic */
            cyclic: boolean;
            /** Stature */
            stature: number;
            /** Poster Time */
            poster_time: number;
            /** Skeleton Hash */
            skeleton_hash: string;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Page Url */
            page_url: string;
            /** Recipe Source */
            recipe_source: string | null;
            /** Variant Of */
            variant_of: string | null;
        };
        /**
         * ClipsAdded
         * @description Clips that a study has now.
         *
         *     Attributes:
         *         title: of the study.
         *         part: that has them.
         *         added, already: ids of those that are new there, and of those that were there before.
         */
        ClipsAdded: {
            /** Title */
            title: string;
            /** Part */
            part: string;
            /** Added */
            added: string[];
            /** Already */
            already: string[];
            draft: components["schemas"]["SavedDraft"];
        };
        /**
         * Cluster
         * @description Pairs that go together.
         *
         *     Attributes:
         *         key: the pair that stands first in it, by which it is known.
         *         members: pair ids in the order of the tree's leaves, those moved into it last.
         *         values: A′, the mean of its pairs for each clip, 0 … 1; None where a pair has no answer.
         */
        Cluster: {
            /** Key */
            key: string;
            /** Title */
            title: string;
            /** Named */
            named: boolean;
            /** Members */
            members: string[];
            /** Values */
            values: (number | null)[];
        };
        /**
         * ClusterStability
         * @description How well a cluster is found again: the mean of its best Jaccard overlap (Hennig 2007).
         */
        ClusterStability: {
            /** Key */
            key: string;
            /** Title */
            title: string;
            /** Overlap */
            overlap: number;
        };
        /**
         * Comparable
         * @description A part of a study that asks for some of the same pairs and has answers.
         */
        Comparable: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /** Part */
            part: string;
        };
        /**
         * ComparableList
         * @description What a part's analysis can be set beside.
         */
        ComparableList: {
            /** Studies */
            studies: components["schemas"]["Comparable"][];
        };
        /**
         * ComparedCluster
         * @description A cluster beside those of another study.
         *
         *     Attributes:
         *         like: index of the other study's cluster that it is matched with; None for none.
         */
        ComparedCluster: {
            /** Key */
            key: string;
            /** Title */
            title: string;
            /** Like */
            like: number | null;
            /** Members */
            members: components["schemas"]["ComparedPair"][];
        };
        /**
         * ComparedPair
         * @description A pair in a cluster that is compared.
         *
         *     Attributes:
         *         differs: whether it is in another cluster elsewhere, or kept by one study only.
         *         turned: whether its study asks for it the other way round; the words are already exchanged.
         */
        ComparedPair: {
            /** Id */
            id: string;
            left: components["schemas"]["Words"];
            right: components["schemas"]["Words"];
            /** Differs */
            differs: boolean;
            /** Turned */
            turned: boolean;
        };
        /**
         * Comparison
         * @description Two studies' solutions side by side.
         *
         *     Attributes:
         *         shared: how many pairs both keep; rand: the adjusted Rand index over them.
         *         turned: how many pairs the other study asks for the other way round; its answers to them
         *             are turned before they are grouped.
         */
        Comparison: {
            /** Here */
            here: string;
            /** There */
            there: string;
            /** Shared */
            shared: number;
            /** Rand */
            rand: number | null;
            /** Turned */
            turned: number;
            /** Here Clusters */
            here_clusters: components["schemas"]["ComparedCluster"][];
            /** There Clusters */
            there_clusters: components["schemas"]["ComparedCluster"][];
            /** Moved */
            moved: components["schemas"]["MovedPair"][];
            /** Sentence */
            sentence: string;
        };
        /**
         * Completion
         * @description Every answer has arrived.
         */
        Completion: {
            /**
             * State
             * @default complete
             * @constant
             */
            state: "complete";
            /** Completion Code */
            completion_code: string;
            /** Answers */
            answers: number;
        };
        /**
         * Contacts
         * @description When each foot stands: stretches from start to end, in seconds.
         * @example {
         *       "left": [
         *         [
         *           0,
         *           0.6
         *         ]
         *       ],
         *       "right": [
         *         [
         *           0.5,
         *           1.1
         *         ]
         *       ]
         *     }
         */
        Contacts: {
            /** Left */
            left: [
                number,
                number
            ][];
            /** Right */
            right: [
                number,
                number
            ][];
        };
        /**
         * Counts
         * @description How far the participants are.
         *
         *     Attributes:
         *         under_way: not complete, with a sign of life (consent or answer) within the study's lease.
         *         left_early: not complete, without one; left_after: how many steps each had answered.
         *         ended: screened out, or ended by failed attention checks.
         *         excluded: left out of the results by a researcher, whatever their state.
         *         answers: rows of the raw answers, practice and earlier revisions included.
         *         median_seconds: from consent to completion, over the complete.
         */
        Counts: {
            /** Complete */
            complete: number;
            /** Under Way */
            under_way: number;
            /** Left Early */
            left_early: number;
            /** Left After */
            left_after: number[];
            /** Ended */
            ended: number;
            /** Excluded */
            excluded: number;
            /** Withdrawn */
            withdrawn: number;
            /** Answers */
            answers: number;
            /** Median Seconds */
            median_seconds: number | null;
        };
        /**
         * DraftList
         * @description What is being edited of every study that the caller may change.
         */
        DraftList: {
            /** Drafts */
            drafts: components["schemas"]["StudyDraft"][];
        };
        /**
         * Dropout
         * @description Where participants stop, of the `of` that are complete or have left.
         *
         *     Attributes:
         *         parts: where each part of the study begins, if that is the same for everybody.
         */
        Dropout: {
            /** Of */
            of: number;
            /** Steps */
            steps: components["schemas"]["DropoutStep"][];
            /** Parts */
            parts: components["schemas"]["PartStart"][];
            /** Sentence */
            sentence: string;
        };
        /**
         * DropoutStep
         * @description How many had answered so many steps and not left; `left` went away at the step after them.
         */
        DropoutStep: {
            /** Answered */
            answered: number;
            /** Still */
            still: number;
            /** Left */
            left: number;
        };
        /**
         * DurationBin
         * @description How many took from `start` to less than `end` seconds; the last one is open (`end` null).
         */
        DurationBin: {
            /** Start */
            start: number;
            /** End */
            end: number | null;
            /** Count */
            count: number;
        };
        /**
         * Durations
         * @description How long complete participants took, from agreeing to the last answer.
         */
        Durations: {
            /** Median Seconds */
            median_seconds: number | null;
            /** Bins */
            bins: components["schemas"]["DurationBin"][];
            /** Sentence */
            sentence: string;
        };
        /**
         * EasedOff
         * @description The recipe at the greatest share, from 0 to 1, that breaks nothing.
         */
        EasedOff: {
            /** Operations */
            operations: components["schemas"]["Step"][];
            /** Share */
            share: number;
            report: components["schemas"]["QualityReport"];
        };
        /**
         * Edit
         * @description What is done to which clip: operations, or the name of a preset.
         *
         *     Attributes:
         *         source: a clip's id.
         *         preset: a name from ``GET /api/v1/presets``.
         * @example {
         *       "operations": [
         *         {
         *           "operation": "grid@1",
         *           "parameters": {
         *             "path": 0.4,
         *             "timing": 1.6
         *           }
         *         },
         *         {
         *           "operation": "posture@1",
         *           "parameters": {
         *             "offsets": [
         *               {
         *                 "amount": 0.8,
         *                 "pose": "head_down"
         *               }
         *             ]
         *           }
         *         }
         *       ],
         *       "source": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
         *     }
         */
        Edit: {
            /** Source */
            source: string;
            /** Operations */
            operations?: components["schemas"]["Step"][] | null;
            /** Preset */
            preset?: string | null;
        };
        /**
         * Enough
         * @description How many participants would do.
         *
         *     Attributes:
         *         index: what the mean adjusted Rand index has to reach.
         *         whole: the least number tried from which on it does for the whole solution, shared: for how
         *             kept pairs are grouped; None if even `most`, the greatest number tried, does not.
         */
        Enough: {
            /** Index */
            index: number;
            /** Most */
            most: number;
            /** Whole */
            whole: number | null;
            /** Shared */
            shared: number | null;
            /** Sentence */
            sentence: string;
        };
        /**
         * ErrorDetail
         * @description What is wrong, where, and what to do.
         * @example {
         *       "code": "clip_not_found",
         *       "mend": "Look for it in the library; it may have been deleted.",
         *       "message": "There is no such clip."
         *     }
         */
        ErrorDetail: {
            /** Code */
            code: string;
            /** Message */
            message: string;
            /** Where */
            where?: {
                [key: string]: unknown;
            } | null;
            /** Mend */
            mend?: string | null;
        } & {
            [key: string]: unknown;
        };
        /**
         * ErrorResponse
         * @description Every answer of the API with a status of 400 or above.
         */
        ErrorResponse: {
            error: components["schemas"]["ErrorDetail"];
        };
        /**
         * Example
         * @description An example motion of a space.
         *
         *     Attributes:
         *         clip: its id in the library.
         *         keytimes: event to seconds from the first frame; empty for an even time-warp.
         *         predicted: nobody rated it; its impressions were predicted from its motion.
         */
        Example: {
            /** Clip */
            clip: string;
            /** Name */
            name: string;
            /** Keytimes */
            keytimes?: {
                [key: string]: number;
            };
            /**
             * Predicted
             * @default false
             */
            predicted: boolean;
        };
        /**
         * ExampleClip
         * @description An example as the studio shows it.
         */
        ExampleClip: {
            /** Clip */
            clip: string;
            /** Name */
            name: string;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Duration */
            duration: number;
        };
        /**
         * FigureView
         * @description A moving figure. Addresses are content hashes: they do not give the clip's name away.
         */
        FigureView: {
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
            /** Cyclic */
            cyclic: boolean;
            /** Caption */
            caption?: string | null;
        };
        /**
         * Finding
         * @description One thing that an edit broke, with its place in time.
         *
         *     Attributes:
         *         kind: such as ``foot slip``; part: the body part.
         *         start, end: seconds.
         *         size: the worst value; limit: what would have been allowed; both in ``unit``.
         * @example {
         *       "end": 0.6,
         *       "kind": "foot slip",
         *       "limit": 0.005,
         *       "part": "left foot",
         *       "size": 0.012,
         *       "start": 0.4,
         *       "unit": "m"
         *     }
         */
        Finding: {
            /** Kind */
            kind: string;
            /** Part */
            part: string;
            /** Start */
            start: number;
            /** End */
            end: number;
            /** Size */
            size: number;
            /** Unit */
            unit: string;
            /** Limit */
            limit: number;
        };
        /**
         * Freeze
         * @description Make an authoring space of the analysis as it is saved.
         * @example {
         *       "name": "Walks of set A"
         *     }
         */
        Freeze: {
            /** Name */
            name: string;
        };
        /**
         * GraphClip
         * @description A clip of a graph; times in seconds.
         */
        GraphClip: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Cyclic */
            cyclic: boolean;
            /** Glb Url */
            glb_url: string;
            /** Figure Url */
            figure_url: string | null;
        };
        /**
         * GraphDetail
         * @description A graph with its transitions.
         */
        GraphDetail: {
            /** Clips */
            clips: {
                [key: string]: string;
            };
            /**
             * Threshold
             * @default 0.07
             */
            threshold: number;
            /**
             * Fade
             * @default 0.3
             */
            fade: number;
            /**
             * Removed
             * @default []
             */
            removed: components["schemas"]["TransitionKey"][];
            /**
             * Added
             * @default []
             */
            added: components["schemas"]["TransitionKey"][];
            /** Fade Frames */
            fade_frames: number;
            /** Transitions */
            transitions: components["schemas"]["TransitionView"][];
            /** Dead Ends */
            dead_ends: number;
            /** Id */
            id: string;
            /** Name */
            name: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "sample" | "own";
            /** Members */
            members: components["schemas"]["GraphClip"][];
        };
        /**
         * GraphList
         * @description All graphs, the sample first.
         */
        GraphList: {
            /** Graphs */
            graphs: components["schemas"]["GraphView"][];
        };
        /**
         * GraphRequest
         * @description A graph to be kept under a name.
         * @example {
         *       "clips": {
         *         "walk": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
         *       },
         *       "fade": 0.3,
         *       "name": "My walker",
         *       "threshold": 0.07
         *     }
         */
        GraphRequest: {
            /** Clips */
            clips: {
                [key: string]: string;
            };
            /**
             * Threshold
             * @default 0.07
             */
            threshold: number;
            /**
             * Fade
             * @default 0.3
             */
            fade: number;
            /**
             * Removed
             * @default []
             */
            removed: components["schemas"]["TransitionKey"][];
            /**
             * Added
             * @default []
             */
            added: components["schemas"]["TransitionKey"][];
            /** Name */
            name: string;
        };
        /**
         * GraphShape
         * @description What a graph is made of.
         *
         *     Attributes:
         *         clips: name within the graph to the clip's id.
         *         threshold: metres, the greatest distance of a transition that is found by itself.
         *         fade: seconds that a cross-fade lasts.
         *         removed: transitions that were found but are left out.
         *         added: transitions that are there whatever their distance.
         * @example {
         *       "added": [],
         *       "clips": {
         *         "walk": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11"
         *       },
         *       "fade": 0.3,
         *       "removed": [],
         *       "threshold": 0.07
         *     }
         */
        GraphShape: {
            /** Clips */
            clips: {
                [key: string]: string;
            };
            /**
             * Threshold
             * @default 0.07
             */
            threshold: number;
            /**
             * Fade
             * @default 0.3
             */
            fade: number;
            /**
             * Removed
             * @default []
             */
            removed: components["schemas"]["TransitionKey"][];
            /**
             * Added
             * @default []
             */
            added: components["schemas"]["TransitionKey"][];
        };
        /**
         * GraphTransitions
         * @description What was found between clips.
         *
         *     Attributes:
         *         fade_frames: frames that a cross-fade lasts.
         *         transitions: those that can be taken for ever.
         *         dead_ends: how many were found but left out, because the way would end after them.
         */
        GraphTransitions: {
            /** Fade Frames */
            fade_frames: number;
            /** Transitions */
            transitions: components["schemas"]["TransitionView"][];
            /** Dead Ends */
            dead_ends: number;
        };
        /**
         * GraphView
         * @description A graph in the list. The sample comes with the server and cannot be changed, only copied.
         */
        GraphView: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "sample" | "own";
            /** Clips */
            clips: string[];
            /** Page Url */
            page_url: string;
            /** Created At */
            created_at: string | null;
        };
        /**
         * GroupCounts
         * @description How many participants of a group stand where; those left out are in none but `excluded`.
         */
        GroupCounts: {
            /** Id */
            id: string | null;
            /** Label */
            label: string;
            /** Complete */
            complete: number;
            /** Under Way */
            under_way: number;
            /** Left Early */
            left_early: number;
            /** Ended Early */
            ended_early: number;
        };
        /**
         * ImportOptions
         * @description What a person says about a file instead of leaving it to be guessed.
         *
         *     Attributes:
         *         unit: metres for one unit of the file.
         *         up_axis: the file's axis that points up.
         *         roles: body role to the name of its joint; an empty name takes a guessed role away.
         *         drop_first_frame: leave out a calibration pose at the start.
         *         fill_gaps: replace missing numbers by values between their neighbours.
         *         root: which of several hierarchies to read, counted from 0.
         *         frame_time: seconds, where the file's is missing or wrong.
         * @example {
         *       "unit": 0.01,
         *       "up_axis": "z"
         *     }
         */
        ImportOptions: {
            /** Unit */
            unit?: number | null;
            /** Up Axis */
            up_axis?: ("x" | "y" | "z" | "-x" | "-y" | "-z") | null;
            /** Roles */
            roles?: {
                [key: string]: string;
            } | null;
            /**
             * Drop First Frame
             * @default false
             */
            drop_first_frame: boolean;
            /**
             * Fill Gaps
             * @default false
             */
            fill_gaps: boolean;
            /** Root */
            root?: number | null;
            /** Frame Time */
            frame_time?: number | null;
        };
        /**
         * ImportReport
         * @description What was found in a file, repaired and guessed.
         *
         *     Attributes:
         *         unit: metres for one unit of the file; stature and lowest_foot in metres.
         *         heading: radians, the way the motion faced before it was turned to +z.
         *         bake_error: metres, the largest deviation from joints whose positions moved in the file.
         */
        ImportReport: {
            /** Repairs */
            repairs: components["schemas"]["Note"][];
            /** Questions */
            questions: components["schemas"]["Note"][];
            /** Unit */
            unit: number;
            /** Unit Name */
            unit_name: string;
            /** Up Axis */
            up_axis: string;
            /** Stature */
            stature: number;
            /** Lowest Foot */
            lowest_foot: number;
            /** Heading */
            heading: number;
            /** Roles */
            roles: {
                [key: string]: string;
            };
            /** Missing Roles */
            missing_roles: string[];
            /** Joint Names */
            joint_names: string[];
            /** Frames */
            frames: number;
            /** Frame Time */
            frame_time: number;
            /** Duration */
            duration: number;
            /** Bake Error */
            bake_error: number;
            /**
             * @default {
             *       "drop_first_frame": false,
             *       "fill_gaps": false
             *     }
             */
            options: components["schemas"]["ImportOptions"];
        } & {
            [key: string]: unknown;
        };
        /**
         * Imported
         * @description A clip that waits for confirmation, or was there already, and its report.
         */
        Imported: {
            clip: components["schemas"]["ClipView"];
            report: components["schemas"]["ImportReport"];
            /**
             * Already There
             * @default false
             */
            already_there: boolean;
        };
        /**
         * Impressions
         * @description The whole analysis of a part.
         *
         *     Attributes:
         *         leaves: the kept pairs in the order of the tree; merges refer to them by place in `kept`.
         *         kept: ids of the kept pairs, in the order of the part.
         *         matrix: A, clips × kept pairs (in `leaves` order), 0 … 1; None where nobody rated.
         *         means, spreads: clips × all pairs in the part's order; None where nobody rated.
         *         reach: the outermost step; answers lie in −reach … reach.
         *         sentence: what came out, in words.
         *         notes: what of the choices or the answers could not be taken in, a sentence each.
         *         problem: why there are no clusters yet; None if there are.
         */
        Impressions: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "participant" | "simulated";
            part: components["schemas"]["PartName"];
            /** Parts */
            parts: components["schemas"]["PartName"][];
            /** Reach */
            reach: number;
            /** Participants */
            participants: number;
            /** Simulated */
            simulated: number;
            choices: components["schemas"]["AnalysisChoices"];
            /** Saved At */
            saved_at: string | null;
            /** Clips */
            clips: components["schemas"]["Rated"][];
            /** Pairs */
            pairs: components["schemas"]["Pair"][];
            /** Kept */
            kept: string[];
            /** Leaves */
            leaves: string[];
            /** Merges */
            merges: components["schemas"]["Merge"][];
            /** Matrix */
            matrix: (number | null)[][];
            /** Means */
            means: (number | null)[][];
            /** Spreads */
            spreads: (number | null)[][];
            /** Clusters */
            clusters: components["schemas"]["Cluster"][];
            /** Sentence */
            sentence: string;
            /** Notes */
            notes: string[];
            /** Problem */
            problem: string | null;
            /** May Edit */
            may_edit: boolean;
        };
        /**
         * Invitation
         * @description A personal link: one participant each.
         */
        Invitation: {
            /** Label */
            label: string;
            /** Url */
            url: string;
        };
        /**
         * InvitationList
         * @description Personal links, in the order of their labels.
         */
        InvitationList: {
            /** Invitations */
            invitations: components["schemas"]["Invitation"][];
        };
        /**
         * InvitationRequest
         * @description For whom personal links are wanted, or how many.
         *
         *     Attributes:
         *         labels: own names for the participants, one link each; the same name gives the same link.
         *         count: how many links with new names, where no labels are given.
         * @example {
         *       "count": 20
         *     }
         */
        InvitationRequest: {
            /**
             * Labels
             * @default []
             */
            labels: string[];
            /**
             * Count
             * @default 1
             */
            count: number;
        };
        /**
         * JobDetail
         * @description A job with what became of each clip, if it makes any.
         * @example {
         *       "created_at": "2026-01-05T09:30:00Z",
         *       "done": 7,
         *       "failed": 0,
         *       "id": "4f0f1e3a-5b7e-4a43-9d5a-6f3f1f0c2d11",
         *       "kind": "clips",
         *       "started_at": "2026-01-05T09:30:01Z",
         *       "state": "running",
         *       "total": 20
         *     }
         */
        JobDetail: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Kind */
            kind: string;
            /**
             * State
             * @enum {string}
             */
            state: "waiting" | "running" | "done" | "cancelled" | "failed";
            /** Total */
            total: number;
            /** Done */
            done: number;
            /** Failed */
            failed: number;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Started At */
            started_at: string | null;
            /** Ended At */
            ended_at: string | null;
            /** Items */
            items: components["schemas"]["JobItem"][];
        };
        /**
         * JobItem
         * @description One clip of a job, in the order asked for: made (`clip`), failed (`error`) or neither yet.
         */
        JobItem: {
            /** Source */
            source: string;
            /** Name */
            name: string;
            /** Clip */
            clip: string | null;
            /** Error */
            error: string | null;
        };
        /**
         * JobList
         * @description The last jobs, the newest first.
         */
        JobList: {
            /** Jobs */
            jobs: components["schemas"]["JobView"][];
        };
        /**
         * JobView
         * @description Long work and how far it is.
         *
         *     Attributes:
         *         kind: `clips`, or `stability` of an analysis of impressions.
         *         total: number of clips; done: of those that are kept; failed: of those that could not be
         *             made. What a cancelled job has made stays. A bootstrap counts pieces of its work.
         * @example {
         *       "created_at": "2026-01-05T09:30:00Z",
         *       "done": 7,
         *       "failed": 0,
         *       "id": "4f0f1e3a-5b7e-4a43-9d5a-6f3f1f0c2d11",
         *       "kind": "clips",
         *       "started_at": "2026-01-05T09:30:01Z",
         *       "state": "running",
         *       "total": 20
         *     }
         */
        JobView: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Kind */
            kind: string;
            /**
             * State
             * @enum {string}
             */
            state: "waiting" | "running" | "done" | "cancelled" | "failed";
            /** Total */
            total: number;
            /** Done */
            done: number;
            /** Failed */
            failed: number;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Started At */
            started_at: string | null;
            /** Ended At */
            ended_at: string | null;
        };
        /**
         * KeytimesView
         * @description The events found in a clip: name to seconds from its first frame.
         * @example {
         *       "keytimes": {
         *         "left_off": 0.68,
         *         "left_strike": 0,
         *         "right_off": 0.14,
         *         "right_strike": 0.54
         *       }
         *     }
         */
        KeytimesView: {
            /** Keytimes */
            keytimes: {
                [key: string]: number;
            };
        };
        /**
         * Label
         * @description A clip's name, and its tags if they change as well.
         * @example {
         *       "name": "walk_sad",
         *       "tags": {
         *         "emotion": "sad"
         *       }
         *     }
         */
        Label: {
            /** Name */
            name: string;
            /** Tags */
            tags?: {
                [key: string]: string;
            } | null;
        };
        /**
         * LanguageView
         * @description A language that the study can be taken in, in its own words.
         */
        LanguageView: {
            /** Id */
            id: string;
            /** Name */
            name: string;
        };
        /**
         * ListedSpace
         * @description A space in the list, as who asks may know it.
         *
         *     Attributes:
         *         study_title: of the study; None if it is none, or one that is not theirs to see.
         *         may_delete: whether they may delete it, unless something needs it.
         */
        ListedSpace: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /** Number */
            number: number;
            /** Newest */
            newest: boolean;
            /** Examples */
            examples: number;
            /** Interfaces */
            interfaces: ("adjectives" | "features" | "weights")[];
            /** Simulated */
            simulated: boolean;
            /** Study */
            study: string | null;
            /** Made By */
            made_by: string | null;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            /** Study Title */
            study_title: string | null;
            /** May Delete */
            may_delete: boolean;
        };
        /**
         * LiveCounts
         * @description How many participants stand where.
         *
         *     Attributes:
         *         under_way: with a sign of life within the lease; left_early: without.
         *         ended_early: sent out by an answer or by failed attention checks.
         *         answers: steps answered, by all of them.
         */
        LiveCounts: {
            /** Complete */
            complete: number;
            /** Under Way */
            under_way: number;
            /** Left Early */
            left_early: number;
            /** Ended Early */
            ended_early: number;
            /** Withdrawn */
            withdrawn: number;
            /** Excluded */
            excluded: number;
            /** Answers */
            answers: number;
        };
        /**
         * LiveView
         * @description All that the live page shows.
         *
         *     Attributes:
         *         kind: of the sessions: participants, or simulated ones.
         *         quota: how many shall complete the study; None: any number.
         *         lease_minutes: after so long without a sign, somebody counts as having left.
         */
        LiveView: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /** State */
            state: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "participant" | "simulated";
            /** Quota */
            quota: number | null;
            /** Lease Minutes */
            lease_minutes: number;
            counts: components["schemas"]["LiveCounts"];
            /** Groups */
            groups: components["schemas"]["GroupCounts"][];
            dropout: components["schemas"]["Dropout"];
            durations: components["schemas"]["Durations"];
            /** Clips */
            clips: components["schemas"]["ClipCount"][];
            /** Clips Sentence */
            clips_sentence: string;
            suspicious: components["schemas"]["SessionList"];
            marked: components["schemas"]["SessionList"];
            latest: components["schemas"]["SessionList"];
        };
        /**
         * MTurk
         * @description Participants come with workerId and assignmentId; a code is shown for them to hand in.
         */
        MTurk: {
            /**
             * Sandbox
             * @default false
             */
            sandbox: boolean;
        };
        /**
         * Manner
         * @description How a character moves: path length and timing as in the grid, amounts of postures.
         * @example {
         *       "path": 1.4,
         *       "postures": {
         *         "head_down": 0.5
         *       },
         *       "timing": 1
         *     }
         */
        Manner: {
            /**
             * Path
             * @default 1
             */
            path: number;
            /**
             * Timing
             * @default 1
             */
            timing: number;
            /**
             * Postures
             * @default {}
             */
            postures: {
                [key: string]: number;
            };
        };
        /**
         * Mark
         * @description What a researcher has set on a session by hand, and why.
         */
        Mark: {
            /** Reason */
            reason: string;
            /** By */
            by: string;
            /**
             * At
             * Format: date-time
             */
            at: string;
        };
        /**
         * MatchBar
         * @description One interface on one target. `target` is null for all of them together.
         *
         *     Attributes:
         *         value: mean or share; low, high: one standard deviation around it, or the interval that the
         *             figure names; n: how many answers.
         */
        MatchBar: {
            /** Target */
            target: string | null;
            /**
             * Interface
             * @enum {string}
             */
            interface: "adjectives" | "features" | "weights";
            /** Value */
            value: number | null;
            /** Low */
            low: number | null;
            /** High */
            high: number | null;
            /** N */
            n: number;
        };
        /**
         * MatchFigure
         * @description One figure.
         *
         *     Attributes:
         *         unit: m, s, or a share of 1 where empty.
         *         reach: what low and high are.
         */
        MatchFigure: {
            /**
             * Name
             * @enum {string}
             */
            name: "guess" | "guessed" | "seconds" | "saved" | "failed";
            /** Title */
            title: string;
            /** Unit */
            unit: string;
            /** Reach */
            reach: string;
            /** Bars */
            bars: components["schemas"]["MatchBar"][];
            /** Sentence */
            sentence: string;
        };
        /**
         * MatchTest
         * @description Two interfaces compared on one target, or on all: null where no pair differs.
         */
        MatchTest: {
            /** Target */
            target: string | null;
            /**
             * One
             * @enum {string}
             */
            one: "adjectives" | "features" | "weights";
            /**
             * Other
             * @enum {string}
             */
            other: "adjectives" | "features" | "weights";
            guess: components["schemas"]["Ranked"] | null;
            seconds: components["schemas"]["Ranked"] | null;
        };
        /**
         * Matching
         * @description A matching experiment's numbers; `reference` is what saved times are compared with.
         */
        Matching: {
            /** Interfaces */
            interfaces: ("adjectives" | "features" | "weights")[];
            /** Targets */
            targets: string[];
            /** Threshold */
            threshold: number;
            /** Limit */
            limit: number;
            /** Reference */
            reference: ("adjectives" | "features" | "weights") | null;
            /** Figures */
            figures: components["schemas"]["MatchFigure"][];
            /** Tests */
            tests: components["schemas"]["MatchTest"][];
            /** Rule */
            rule: string;
        };
        /**
         * Member
         * @description A researcher who belongs to a study.
         */
        Member: {
            /** Email */
            email: string;
            /** Name */
            name: string;
            /**
             * Role
             * @enum {string}
             */
            role: "owner" | "editor" | "viewer";
            /** You */
            you: boolean;
        };
        /**
         * MemberList
         * @description A study's members.
         *
         *     Attributes:
         *         role: what the asking researcher is.
         *         everybodys: the study has no members; every researcher is its owner.
         */
        MemberList: {
            /** Members */
            members: components["schemas"]["Member"][];
            /**
             * Role
             * @enum {string}
             */
            role: "owner" | "editor" | "viewer";
            /** Everybodys */
            everybodys: boolean;
        };
        /**
         * MemberRole
         * @description What a member shall be.
         */
        MemberRole: {
            /**
             * Role
             * @enum {string}
             */
            role: "owner" | "editor" | "viewer";
        };
        /**
         * Merge
         * @description Two branches of the tree become one. Leaves are numbered from 0, then merges.
         *
         *     Attributes:
         *         height: √(2ΔE), as SciPy and R (`ward.D2`) give it; increase: ΔE of eq. 4.
         */
        Merge: {
            /** Left */
            left: number;
            /** Right */
            right: number;
            /** Height */
            height: number;
            /** Increase */
            increase: number;
            /** Size */
            size: number;
        };
        /**
         * Motion
         * @description A motion in numbers: metres, seconds, local rotations as quaternions w, x, y, z.
         *
         *     Attributes:
         *         parents: of each joint, −1 for the root; offsets: from the parent.
         *         root_positions: of each frame; rotations: of each frame and joint.
         */
        Motion: {
            /** Names */
            names: string[];
            /** Parents */
            parents: number[];
            /** Offsets */
            offsets: [
                number,
                number,
                number
            ][];
            /** Frame Time */
            frame_time: number;
            /** Root Positions */
            root_positions: [
                number,
                number,
                number
            ][];
            /** Rotations */
            rotations: [
                number,
                number,
                number,
                number
            ][][];
        };
        /**
         * Moved
         * @description Where the sliders of a match stand.
         */
        Moved: {
            /** Values */
            values: {
                [key: string]: number;
            };
        };
        /**
         * MovedPair
         * @description A pair that two solutions put into different clusters, or that only one of them keeps.
         */
        MovedPair: {
            /** Id */
            id: string;
            left: components["schemas"]["Words"];
            right: components["schemas"]["Words"];
            /** Here */
            here: string | null;
            /** There */
            there: string | null;
        };
        /**
         * NewClips
         * @description Clips for a study, by their ids.
         *
         *     Attributes:
         *         part: that shall have them; left out, the first that asks about clips. A study without any
         *             gets one, with one question.
         * @example {
         *       "clips": [
         *         "0f4c2b5f…"
         *       ],
         *       "part": "walks"
         *     }
         */
        NewClips: {
            /** Clips */
            clips: string[];
            /** Part */
            part?: string | null;
        };
        /**
         * NewSpace
         * @description A space made from clips alone, without a questionnaire: its sliders are motion features.
         * @example {
         *       "clips": [
         *         "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *         "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"
         *       ],
         *       "name": "Two walks"
         *     }
         */
        NewSpace: {
            /** Name */
            name: string;
            /** Clips */
            clips: string[];
            /**
             * Keytimes
             * @default {}
             */
            keytimes: {
                [key: string]: {
                    [key: string]: number;
                };
            };
        };
        /**
         * NewStudy
         * @description What a new study is made from: a template, a definition, or a study file; else it is empty.
         *
         *     Attributes:
         *         template: id of one of the templates.
         *         definition: a study file's content; it need not be complete.
         *         title: in the place of the template's own.
         *         clips: ids, for the first part that asks about clips, in the place of its own; an empty
         *             study gets such a part.
         * @example {
         *       "title": "Gaits"
         *     }
         */
        NewStudy: {
            /** Template */
            template?: string | null;
            /** Definition */
            definition?: {
                [key: string]: unknown;
            } | null;
            file?: components["schemas"]["UploadedFile"] | null;
            /** Title */
            title?: string | null;
            /**
             * Clips
             * @default []
             */
            clips: string[];
        };
        /**
         * NewVersion
         * @description What a space's next version changes.
         *
         *     Attributes:
         *         keytimes: clip id to its events, all of them.
         *         join: clips that nobody rated; their impressions are predicted from their motion.
         * @example {
         *       "join": [
         *         "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"
         *       ],
         *       "keytimes": {
         *         "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11": {
         *           "left_off": 0.68,
         *           "left_strike": 0,
         *           "right_off": 0.14,
         *           "right_strike": 0.54
         *         }
         *       }
         *     }
         */
        NewVersion: {
            /**
             * Keytimes
             * @default {}
             */
            keytimes: {
                [key: string]: {
                    [key: string]: number;
                };
            };
            /**
             * Join
             * @default []
             */
            join: string[];
        };
        /**
         * Note
         * @description One line of an import report: what was repaired, or what a person should confirm.
         * @example {
         *       "line": 217,
         *       "text": "A tab separates two numbers",
         *       "where": "line 217"
         *     }
         */
        Note: {
            /** Text */
            text: string;
            /** Line */
            line?: number | null;
            /** Where */
            where?: string | null;
            /** Offer */
            offer?: string | null;
        };
        /**
         * OperationList
         * @description Everything that a recipe's steps can do.
         */
        OperationList: {
            /** Operations */
            operations: components["schemas"]["OperationView"][];
        };
        /**
         * OperationView
         * @description One kind of step.
         *
         *     Attributes:
         *         name: as recipes write it, with its version.
         *         parameters: JSON Schema (2020-12) with ``unit``, range and ``default`` of each.
         * @example {
         *       "name": "tempo@1",
         *       "parameters": {
         *         "$schema": "https://json-schema.org/draft/2020-12/schema",
         *         "additionalProperties": false,
         *         "properties": {
         *           "factor": {
         *             "default": 1,
         *             "maximum": 4,
         *             "minimum": 0.25,
         *             "type": "number"
         *           }
         *         },
         *         "type": "object"
         *       },
         *       "summary": "Makes the whole motion faster or slower.",
         *       "title": "Tempo"
         *     }
         */
        OperationView: {
            /** Name */
            name: string;
            /** Title */
            title: string;
            /** Summary */
            summary: string;
            /** Parameters */
            parameters: {
                [key: string]: unknown;
            };
        };
        /**
         * Origin
         * @description What a space's numbers come from.
         *
         *     Attributes:
         *         study, part, versions: whose answers; versions by their hashes.
         *         kind: whose answers: people's, or those of simulated raters.
         *         participants: how many were analysed.
         *         least_peak, most_spread: which pairs were kept.
         *         moved: pairs whose cluster was chosen by hand.
         *         before: the version of the space that this one was made from.
         *         note: what else there is to know, in a sentence.
         */
        Origin: {
            /** Study */
            study?: string | null;
            /** Part */
            part?: string | null;
            /**
             * Versions
             * @default []
             */
            versions: string[];
            /** Kind */
            kind?: ("participant" | "simulated") | null;
            /** Participants */
            participants?: number | null;
            /** Least Peak */
            least_peak?: number | null;
            /** Most Spread */
            most_spread?: number | null;
            /**
             * Moved
             * @default []
             */
            moved: string[];
            /** Before */
            before?: string | null;
            /**
             * Note
             * @default
             */
            note: string;
        };
        /**
         * Pair
         * @description A pair of adjectives.
         *
         *     Attributes:
         *         peak: μ*, the greatest mean of any clip, without its sign.
         *         spread: σ̄, the mean over clips of the raters' sample standard deviation; None where no clip
         *             has two raters.
         *         dropped: why it is left out, in a sentence; None for a kept one.
         *         cluster: index of its cluster; None for a dropped one.
         */
        Pair: {
            /** Id */
            id: string;
            left: components["schemas"]["Words"];
            right: components["schemas"]["Words"];
            /** Peak */
            peak: number | null;
            /** Spread */
            spread: number | null;
            /** Dropped */
            dropped: string | null;
            /** Cluster */
            cluster: number | null;
            /** Moved */
            moved: boolean;
        };
        /**
         * PairStability
         * @description How often a pair stays when participants are drawn anew.
         */
        PairStability: {
            /** Id */
            id: string;
            /** Kept */
            kept: number;
        };
        /**
         * Parameter
         * @description A pair of adjectives, or a motion feature: where every example lies between its ends.
         *
         *     Attributes:
         *         title, about: of a feature, its name and what it measures; a pair is named by its ends.
         *         left, right: what 0 and 1 look like.
         *         unit, lowest, highest: of a feature, what 0 and 1 stand for.
         *         values: one for each example, in their order.
         */
        Parameter: {
            /** Id */
            id: string;
            title?: components["schemas"]["Words"] | null;
            /** About */
            about?: string | null;
            left: components["schemas"]["Words"];
            right: components["schemas"]["Words"];
            /** Unit */
            unit?: string | null;
            /** Lowest */
            lowest?: number | null;
            /** Highest */
            highest?: number | null;
            /** Values */
            values: number[];
        };
        /**
         * PartName
         * @description A part that asks about clips: its kind of trial, and what it asks.
         */
        PartName: {
            /** Id */
            id: string;
            /** Kind */
            kind: string;
            /** Question */
            question: string;
        };
        /**
         * PartStart
         * @description A part of the study begins after so many steps.
         */
        PartStart: {
            /** Start */
            start: number;
            /** Name */
            name: string;
        };
        /**
         * Piece
         * @description A short stretch of motion, and where it leads.
         *
         *     Attributes:
         *         frames, joints: its size.
         *         motion: base64 of little-endian float32: for each frame the root's x, y, z in metres, then
         *             for each joint the local rotation as x, y, z, w.
         *         after: the place after it: send it back for the next piece.
         *         blended: the piece is one cross-fade. Of another piece, any beginning may be shown alone:
         *             the place then is that of its start, so many frames on.
         *         taken: the transition that it is.
         *         ahead: the next transition on the way; wait: frames until it begins.
         *         reaches: frames from the piece's end until the wanted clip is reached.
         * @example {
         *       "after": {
         *         "clip": "stand",
         *         "frame": 1,
         *         "manner": {},
         *         "turn": 0,
         *         "x": 0,
         *         "z": 0
         *       },
         *       "ahead": {
         *         "source": "stand",
         *         "source_frame": 30,
         *         "target": "walk",
         *         "target_frame": 12
         *       },
         *       "blended": false,
         *       "frames": 1,
         *       "joints": 1,
         *       "motion": "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAACAPw==",
         *       "reaches": 47,
         *       "wait": 29
         *     }
         */
        Piece: {
            /** Frames */
            frames: number;
            /** Joints */
            joints: number;
            /** Motion */
            motion: string;
            after: components["schemas"]["Place"];
            /** Blended */
            blended: boolean;
            taken: components["schemas"]["TransitionKey"] | null;
            ahead: components["schemas"]["TransitionKey"] | null;
            /** Wait */
            wait: number;
            /** Reaches */
            reaches: number;
        };
        /**
         * Place
         * @description Where a character is: its next frame, and where on the floor that clip is played.
         *
         *     Attributes:
         *         turn: radians about the vertical; x, z: metres.
         * @example {
         *       "clip": "stand",
         *       "frame": 0,
         *       "manner": {},
         *       "turn": 0,
         *       "x": 0,
         *       "z": 0
         *     }
         */
        Place: {
            /** Clip */
            clip: string;
            /**
             * Frame
             * @default 0
             */
            frame: number;
            /**
             * Turn
             * @default 0
             */
            turn: number;
            /**
             * X
             * @default 0
             */
            x: number;
            /**
             * Z
             * @default 0
             */
            z: number;
            /**
             * @default {
             *       "path": 1,
             *       "timing": 1,
             *       "postures": {}
             *     }
             */
            manner: components["schemas"]["Manner"];
        };
        /**
         * Plan
         * @description What a choice comes to, in its order.
         */
        Plan: {
            /** Items */
            items: components["schemas"]["PlannedClip"][];
        };
        /**
         * PlannedClip
         * @description A clip that a set will hold.
         *
         *     Attributes:
         *         name, tags: as proposed; both may be changed before it is made.
         *         clip: its id if the library has it already.
         */
        PlannedClip: {
            /** Source */
            source: string;
            /** Source Name */
            source_name: string;
            /** Preset */
            preset: string;
            /** Preset Title */
            preset_title: string;
            /** Name */
            name: string;
            /** Tags */
            tags: {
                [key: string]: string;
            };
            /** Clip */
            clip: string | null;
        };
        /**
         * PlayRequest
         * @description The next piece of motion that is wanted.
         *
         *     Attributes:
         *         place: as the piece before has told it.
         *         target: the clip that is wanted.
         *         manner: how it shall move from now on.
         *         frames: at the most; a cross-fade lasts as long as it does.
         *         via: a transition to be taken when it comes, whatever the way.
         * @example {
         *       "frames": 18,
         *       "manner": {},
         *       "place": {
         *         "clip": "stand"
         *       },
         *       "target": "walk"
         *     }
         */
        PlayRequest: {
            place: components["schemas"]["Place"];
            /** Target */
            target: string;
            /**
             * @default {
             *       "path": 1,
             *       "timing": 1,
             *       "postures": {}
             *     }
             */
            manner: components["schemas"]["Manner"];
            /**
             * Frames
             * @default 18
             */
            frames: number;
            via?: components["schemas"]["TransitionKey"] | null;
        };
        /**
         * Point
         * @description What an author wants.
         *
         *     Attributes:
         *         interface: what the values are about.
         *         values: slider's or example's id to its value; for adjectives and features, those not named
         *             take no part: only the named sliders span the space. For weights, an example's clip id
         *             to its weight; those not named weigh nothing.
         * @example {
         *       "interface": "adjectives",
         *       "values": {
         *         "largeness": 0.6,
         *         "quickness": 0.8
         *       }
         *     }
         */
        Point: {
            /**
             * Interface
             * @enum {string}
             */
            interface: "adjectives" | "features" | "weights";
            /** Values */
            values: {
                [key: string]: number;
            };
        };
        /**
         * PoleRow
         * @description One row of "Is every quality seen?": a pole's best clip against its body's clips.
         *
         *     Attributes:
         *         mean, others: means toward the pole, of the best clip and of its comparison group.
         *         p_holm: Welch's p adjusted over all the poles.
         *         p_permuted: of a permutation test that repeats the choice of the best clip; p_permuted_holm:
         *             adjusted over all the poles.
         *         paired_t: over participants' means, the best clip less the mean of the group.
         */
        PoleRow: {
            /** Scale */
            scale: string;
            /** Pole */
            pole: string;
            clip: components["schemas"]["Clip"] | null;
            /** Mean */
            mean: number | null;
            /** Others */
            others: number | null;
            /** Difference */
            difference: number | null;
            /** T */
            t: number | null;
            /** Df */
            df: number | null;
            /** P */
            p: number | null;
            /** P Holm */
            p_holm: number | null;
            /** P Permuted */
            p_permuted: number | null;
            /** P Permuted Holm */
            p_permuted_holm: number | null;
            /** D */
            d: number | null;
            /** D Low */
            d_low: number | null;
            /** D High */
            d_high: number | null;
            /** Paired T */
            paired_t: number | null;
            /** Paired Df */
            paired_df: number | null;
            /** Paired P */
            paired_p: number | null;
            /** Sentence */
            sentence: string | null;
        };
        /**
         * PoseList
         * @description The poses that posture offsets can be made of.
         */
        PoseList: {
            /** Poses */
            poses: components["schemas"]["PoseView"][];
        };
        /**
         * PoseRequest
         * @description Which frame of which clip, counted from 0, to keep as a pose.
         * @example {
         *       "clip": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "frame": 12,
         *       "name": "bent"
         *     }
         */
        PoseRequest: {
            /** Clip */
            clip: string;
            /** Frame */
            frame: number;
            /** Name */
            name: string;
        };
        /**
         * PoseView
         * @description A standing pose: one that comes with the server (``stance``), or one from a clip.
         *
         *     Attributes:
         *         id: what recipes call it by.
         *         rotations: body role to rotation (w, x, y, z) in canonical axes.
         * @example {
         *       "clip": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "created_at": "2026-01-31T12:00:00Z",
         *       "frame": 12,
         *       "id": "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08",
         *       "name": "bent",
         *       "rotations": {
         *         "head": [
         *           0.98,
         *           0.2,
         *           0,
         *           0
         *         ]
         *       },
         *       "stance": false
         *     }
         */
        PoseView: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /** Stance */
            stance: boolean;
            /** Clip */
            clip: string | null;
            /** Frame */
            frame: number | null;
            /** Created At */
            created_at: string | null;
            /** Rotations */
            rotations: {
                [key: string]: number[];
            };
        };
        /**
         * PredictedParameter
         * @description What a pair's impression is predicted to be.
         *
         *     Attributes:
         *         value, low, high: the prediction and its 95 % interval, 0 to 1; None where refused.
         *         error, error_of_mean: root mean square of leaving one out, and of always saying the mean;
         *             None where too few clips were rated to tell.
         *         sentence: how good it is, or why it is refused.
         */
        PredictedParameter: {
            /** Id */
            id: string;
            left: components["schemas"]["Words"];
            right: components["schemas"]["Words"];
            /** Refused */
            refused: boolean;
            /** Value */
            value: number | null;
            /** Low */
            low: number | null;
            /** High */
            high: number | null;
            /** Error */
            error: number | null;
            /** Error Of Mean */
            error_of_mean: number | null;
            /** Sentence */
            sentence: string;
        };
        /**
         * Prediction
         * @description The impressions that a clip would have in a space.
         *
         *     Attributes:
         *         level: of the intervals: the share of new clips that they hold, as far as the number of
         *             rated clips allows; None if nothing is learnt.
         */
        Prediction: {
            /** Clip */
            clip: string;
            /** Parameters */
            parameters: components["schemas"]["PredictedParameter"][];
            /** Level */
            level: number | null;
            /** Can Join */
            can_join: boolean;
            /** Sentence */
            sentence: string;
        };
        /**
         * PresetList
         * @description The recipes that come with the server.
         */
        PresetList: {
            /** Presets */
            presets: components["schemas"]["PresetView"][];
        };
        /**
         * PresetView
         * @description A recipe with a name and the emotion that it is meant to show.
         * @example {
         *       "axis": "sad_happy",
         *       "emotion": "sad",
         *       "name": "sad",
         *       "operations": [
         *         {
         *           "operation": "grid@1",
         *           "parameters": {
         *             "path": 0.4,
         *             "timing": 1.6
         *           }
         *         },
         *         {
         *           "operation": "posture@1",
         *           "parameters": {
         *             "offsets": [
         *               {
         *                 "amount": 0.8,
         *                 "pose": "head_down"
         *               }
         *             ]
         *           }
         *         }
         *       ],
         *       "pole": "sad",
         *       "summary": "Shorter paths, even speed, the head down.",
         *       "title": "Sad"
         *     }
         */
        PresetView: {
            /** Name */
            name: string;
            /** Title */
            title: string;
            /** Summary */
            summary: string;
            /** Emotion */
            emotion: string;
            /** Axis */
            axis: string;
            /** Pole */
            pole: string;
            /** Operations */
            operations: components["schemas"]["Step"][];
        };
        /**
         * Primary
         * @description A cluster of parameters as one slider.
         *
         *     Attributes:
         *         members: the parameters that it is the mean of.
         *         values: one for each example, in their order.
         */
        Primary: {
            /** Id */
            id: string;
            title: components["schemas"]["Words"];
            /** Members */
            members: string[];
            /** Values */
            values: number[];
        };
        /**
         * Problem
         * @description What stands in the way of publishing, where in the study file, and the mend.
         * @example {
         *       "mend": "Write something here.",
         *       "message": "This is empty.",
         *       "where": [
         *         "parts",
         *         0,
         *         "task",
         *         "question"
         *       ]
         *     }
         */
        Problem: {
            /** Where */
            where: (string | number)[];
            /** Message */
            message: string;
            /** Mend */
            mend?: string | null;
        };
        /**
         * Prolific
         * @description Participants come with PROLIFIC_PID, STUDY_ID and SESSION_ID, and go back with a code.
         */
        Prolific: {
            /** Complete */
            complete: string;
            /** Screened Out */
            screened_out?: string | null;
            /** Failed Attention */
            failed_attention?: string | null;
        };
        /**
         * Provenance
         * @description What an edited clip is made of.
         *
         *     Attributes:
         *         source: id of the clip that was edited; source_hash: hash of its motion.
         *         recipe: every step with all its parameters.
         *         engine_version: of the motion library that made it; current_engine: whether that one is
         *             still in use here.
         *         content_hash: hash of the edited motion.
         */
        Provenance: {
            /** Source */
            source: string;
            /** Source Name */
            source_name: string;
            /** Source Hash */
            source_hash: string;
            /** Recipe */
            recipe: components["schemas"]["Step"][];
            /** Recipe Hash */
            recipe_hash: string;
            /** Engine Version */
            engine_version: string;
            /** Current Engine */
            current_engine: boolean;
            /** Content Hash */
            content_hash: string;
        };
        /**
         * QualityReport
         * @description Everything that an edit broke, in the order of time.
         * @example {
         *       "clean": false,
         *       "findings": [
         *         {
         *           "end": 0.6,
         *           "kind": "foot slip",
         *           "limit": 0.005,
         *           "part": "left foot",
         *           "size": 0.012,
         *           "start": 0.4,
         *           "unit": "m"
         *         }
         *       ]
         *     }
         */
        QualityReport: {
            /** Clean */
            clean: boolean;
            /** Findings */
            findings: components["schemas"]["Finding"][];
        };
        /**
         * Ranked
         * @description Wilcoxon's signed-rank test, two-sided.
         *
         *     Attributes:
         *         n: pairs that differ; zeros: pairs that do not, which are left out.
         *         exact: whether p is exact, and not by the normal distribution.
         */
        Ranked: {
            /** Statistic */
            statistic: number;
            /** P */
            p: number;
            /** N */
            n: number;
            /** Zeros */
            zeros: number;
            /** Exact */
            exact: boolean;
        };
        /**
         * Rated
         * @description A clip of the study.
         */
        Rated: {
            /** Clip */
            clip: string;
            /** Name */
            name: string;
            /** Label */
            label: string;
            /** Raters */
            raters: number;
        };
        /**
         * Reason
         * @description Why; it is kept in the audit trail.
         */
        Reason: {
            /** Reason */
            reason: string;
        };
        /**
         * Rebuilt
         * @description A clip made again from its recipe.
         *
         *     Attributes:
         *         identical: whether the motion came out the same to the last bit.
         *         clip: the clip of this engine: the same one, or a new one beside that of an older engine.
         */
        Rebuilt: {
            /** Identical */
            identical: boolean;
            clip: components["schemas"]["ClipDetail"];
        };
        /**
         * ReplayFigure
         * @description A figure as it stood on the page; the third of `abx` is X again.
         */
        ReplayFigure: {
            /** Glb Url */
            glb_url: string | null;
            /** Figure Url */
            figure_url: string | null;
            /** Name */
            name: string;
        };
        /**
         * ReplayStep
         * @description One step of a participant's way, and the newest answer to it.
         *
         *     Attributes:
         *         note: what was special about it: practice, an attention check and whether it held.
         *         answers: empty without an answer, and on pages without a question.
         *         changed: how often the answer was changed.
         *         at: when it was stored; `seconds` since the one before (or since agreeing).
         *         camera: [ms since the figures came, azimuth and elevation in degrees, zoom] of the view, as
         *             far as it was recorded.
         */
        ReplayStep: {
            /** Index */
            index: number;
            /** Part */
            part: string;
            /** Kind */
            kind: string;
            /** Title */
            title: string;
            /** Note */
            note: string | null;
            /** Figures */
            figures: components["schemas"]["ReplayFigure"][];
            reference: components["schemas"]["ReplayFigure"] | null;
            /** Answered */
            answered: boolean;
            /** Answers */
            answers: components["schemas"]["ToldAnswer"][];
            /** Comment */
            comment: string;
            /** Changed */
            changed: number;
            /** Rt Ms */
            rt_ms: number | null;
            /** At */
            at: string | null;
            /** Viewed */
            viewed: components["schemas"]["Viewed"][];
            /** Camera */
            camera: [
                number,
                number,
                number,
                number
            ][];
        };
        /**
         * ResponseView
         * @description The newest stored answer of a step.
         */
        ResponseView: {
            /** Revision */
            revision: number;
            /** Answers */
            answers: {
                [key: string]: unknown;
            };
            /** Touched */
            touched: string[];
            /** Comment */
            comment: string;
        };
        /**
         * Retargeting
         * @description How well a motion would fit the skeleton of another clip.
         *
         *     Attributes:
         *         same: both clips move the same skeleton already.
         *         fits: whether what changes stays within what a viewer would hardly see.
         *         sentence: all of this in words.
         *         mean_direction, greatest_direction: radians between the directions of the limbs' segments
         *             before and after, over all frames.
         *         slip: metres, the farthest that a point of a sole slides while it stands.
         *         sole_height: metres that a standing sole is above or below the floor, in the mean.
         *         unmapped: body roles that only one of the two skeletons has.
         *         resting: joints of the new skeleton that rest as in standing: their role is in it alone, or
         *             they have none.
         * @example {
         *       "fits": true,
         *       "greatest_direction": 0.021,
         *       "mean_direction": 0.004,
         *       "resting": [
         *         "LeftToe"
         *       ],
         *       "same": false,
         *       "sentence": "The motion fits: limbs point where they pointed within 1.2°, standing feet slide by 4 mm at most and are 1 mm off the floor. One joint of the new body rests: LeftToe.",
         *       "slip": 0.004,
         *       "sole_height": 0.001,
         *       "unmapped": []
         *     }
         */
        Retargeting: {
            /** Same */
            same: boolean;
            /** Fits */
            fits: boolean;
            /** Sentence */
            sentence: string;
            /** Mean Direction */
            mean_direction: number;
            /** Greatest Direction */
            greatest_direction: number;
            /** Slip */
            slip: number;
            /** Sole Height */
            sole_height: number;
            /** Unmapped */
            unmapped: string[];
            /** Resting */
            resting: string[];
        };
        /**
         * Running
         * @description How a study is run.
         *
         *     Attributes:
         *         open_link: whoever has the study's address may take part; else only personal links and
         *             recruiting services lead in.
         *         quota: how many may complete it; None means any number.
         *         opens_at, closes_at: when new participants may begin.
         *         lease_minutes: without an answer for so long, a participant's slot goes to another; coming
         *             back on the personal link stays possible.
         *         resume_days: for so long after the beginning the personal link can be gone on with.
         *         retention_days: so long after the last answer, everything personal is deleted; None: never.
         *         fail_after: so many failed attention checks end the study for a participant; None: none do.
         */
        Running: {
            /**
             * Open Link
             * @default true
             */
            open_link: boolean;
            /** Quota */
            quota?: number | null;
            /** Opens At */
            opens_at?: string | null;
            /** Closes At */
            closes_at?: string | null;
            /**
             * Lease Minutes
             * @default 60
             */
            lease_minutes: number;
            /**
             * Resume Days
             * @default 30
             */
            resume_days: number;
            /** Retention Days */
            retention_days?: number | null;
            /** Fail After */
            fail_after?: number | null;
            prolific?: components["schemas"]["Prolific"] | null;
            sona?: components["schemas"]["Sona"] | null;
            mturk?: components["schemas"]["MTurk"] | null;
        };
        /**
         * SavedDraft
         * @description A draft that was saved, what stands in the way of publishing it, and of its preview.
         */
        SavedDraft: {
            /**
             * Saved At
             * Format: date-time
             */
            saved_at: string;
            /** Problems */
            problems: components["schemas"]["Problem"][];
            /** Can Be Shown */
            can_be_shown: boolean;
        };
        /**
         * SessionDetail
         * @description One participant's way through the study (its title), step by step.
         */
        SessionDetail: {
            /** Study */
            study: string;
            session: components["schemas"]["SessionLine"];
            /** Version */
            version: number;
            /** Slot */
            slot: number | null;
            /** Seed */
            seed: number | null;
            /** Consented At */
            consented_at: string | null;
            /** Completed At */
            completed_at: string | null;
            /** Steps */
            steps: components["schemas"]["ReplayStep"][];
            /** Trail */
            trail: components["schemas"]["AuditLine"][];
        };
        /**
         * SessionLine
         * @description One participant in a list.
         *
         *     Attributes:
         *         name: the first digits of the id, to tell participants apart by.
         *         stands: how far the participant is, in words; `left_early` after a while without a sign.
         *         seconds: from agreeing to the last answer; None before the first.
         *         excluded: why a researcher left the session out of the results; None: it counts.
         *         flag: a mark by hand, to look at it again.
         */
        SessionLine: {
            /**
             * Id
             * Format: uuid
             */
            id: string;
            /** Name */
            name: string;
            /**
             * State
             * @enum {string}
             */
            state: "active" | "complete" | "screened_out" | "failed_attention" | "withdrawn";
            /**
             * Stands
             * @enum {string}
             */
            stands: "complete" | "under_way" | "left_early" | "ended_early" | "withdrawn";
            /** Group */
            group: string | null;
            /** Language */
            language: string | null;
            /** Device */
            device: string | null;
            /** Source */
            source: string | null;
            /**
             * Began
             * Format: date-time
             */
            began: string;
            /** Answered */
            answered: number;
            /** Steps */
            steps: number;
            /** Seconds */
            seconds: number | null;
            /** Suspicions */
            suspicions: components["schemas"]["Suspicion"][];
            excluded: components["schemas"]["Mark"] | null;
            flag: components["schemas"]["Mark"] | null;
        };
        /**
         * SessionList
         * @description Sessions to look at, the latest first; `total` may be more than are listed.
         */
        SessionList: {
            /** Total */
            total: number;
            /** Sessions */
            sessions: components["schemas"]["SessionLine"][];
        };
        /**
         * SessionView
         * @description A session as its page needs it; `next` is the first step without an answer, or their number.
         *
         *     The steps of a withdrawn session are gone with its answers.
         *
         *     Attributes:
         *         parts: part to what it asks or says: a trial's task, or a page, texts in one language.
         */
        SessionView: {
            study: components["schemas"]["StudyView"];
            /**
             * State
             * @enum {string}
             */
            state: "active" | "complete" | "screened_out" | "failed_attention" | "withdrawn";
            /** Parts */
            parts: {
                [key: string]: {
                    [key: string]: unknown;
                };
            };
            /** Steps */
            steps: components["schemas"]["StepView"][];
            /** Responses */
            responses: {
                [key: string]: components["schemas"]["ResponseView"];
            };
            /** Next */
            next: number;
        };
        /**
         * Share
         * @description How often something was chosen of the times that it could be.
         *
         *     Attributes:
         *         name: a clip's label, “none of them”, “no difference”, or the two clips of a pair.
         *         clip: null where it is no clip.
         *         share, low, high: in 0 ... 1, with Wilson's 95 % interval.
         */
        Share: {
            /** Name */
            name: string;
            /** Clip */
            clip: string | null;
            /** Chosen */
            chosen: number;
            /** Shown */
            shown: number;
            /** Share */
            share: number | null;
            /** Low */
            low: number | null;
            /** High */
            high: number | null;
        };
        /**
         * SkeletonList
         * @description The skeletons of the library, that with most clips first.
         */
        SkeletonList: {
            /** Skeletons */
            skeletons: components["schemas"]["SkeletonView"][];
        };
        /**
         * SkeletonView
         * @description A skeleton of the library that a figure can stand on.
         *
         *     Attributes:
         *         id: what its clips tell as their ``skeleton_hash``.
         *         clips: how many kept clips move it.
         *         example: one of them, by which people know the body; a recipe names it to put a motion
         *             onto this skeleton.
         */
        SkeletonView: {
            /** Id */
            id: string;
            /** Clips */
            clips: number;
            example: components["schemas"]["ClipView"];
        };
        /**
         * Sliders
         * @description What an author can move: the primary sliders, and every single parameter besides.
         */
        Sliders: {
            /** Primary */
            primary: components["schemas"]["Primary"][];
            /** Parameters */
            parameters: components["schemas"]["Parameter"][];
        };
        /**
         * Sona
         * @description Participants come with `?id=`; `credit_url` grants the credit, `{id}` in it is theirs.
         */
        Sona: {
            /** Credit Url */
            credit_url: string;
        };
        /**
         * SpaceDefinition
         * @description A whole space. Without a questionnaire there are no adjectives.
         */
        SpaceDefinition: {
            /**
             * Manner
             * @default 1
             * @constant
             */
            manner: 1;
            /** Title */
            title: string;
            /** Examples */
            examples: components["schemas"]["Example"][];
            adjectives?: components["schemas"]["Sliders"] | null;
            features: components["schemas"]["Sliders"];
            /**
             * @default {
             *       "versions": [],
             *       "moved": [],
             *       "note": ""
             *     }
             */
            origin: components["schemas"]["Origin"];
        };
        /**
         * SpaceDetail
         * @description A space with all its numbers.
         *
         *     Attributes:
         *         clips: the examples' files, in their order.
         *         notes: of each interface, what there is to know about its examples' places, in sentences.
         */
        SpaceDetail: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /** Number */
            number: number;
            /** Newest */
            newest: boolean;
            /** Examples */
            examples: number;
            /** Interfaces */
            interfaces: ("adjectives" | "features" | "weights")[];
            /** Simulated */
            simulated: boolean;
            /** Study */
            study: string | null;
            /** Made By */
            made_by: string | null;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
            definition: components["schemas"]["SpaceDefinition"];
            /** Clips */
            clips: components["schemas"]["ExampleClip"][];
            /** Notes */
            notes: {
                [key: string]: string[];
            };
        };
        /**
         * SpaceLine
         * @description A space in the list.
         *
         *     Attributes:
         *         number: 1, 2, … of the spaces with the same name.
         *         newest: whether it is the newest of them.
         */
        SpaceLine: {
            /** Id */
            id: string;
            /** Name */
            name: string;
            /** Number */
            number: number;
            /** Newest */
            newest: boolean;
            /** Examples */
            examples: number;
            /** Interfaces */
            interfaces: ("adjectives" | "features" | "weights")[];
            /** Simulated */
            simulated: boolean;
            /** Study */
            study: string | null;
            /** Made By */
            made_by: string | null;
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * SpaceList
         * @description Every space, newest first.
         */
        SpaceList: {
            /** Spaces */
            spaces: components["schemas"]["ListedSpace"][];
        };
        /**
         * SpaceRecipe
         * @description A point as an ordinary recipe: `source` and `operations` as every edit has them.
         * @example {
         *       "notes": [],
         *       "operations": [
         *         {
         *           "operation": "blend@1",
         *           "parameters": {
         *             "examples": [
         *               {
         *                 "clip": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *                 "keytimes": {
         *                   "left_off": 0.68,
         *                   "left_strike": 0,
         *                   "right_off": 0.14,
         *                   "right_strike": 0.54
         *                 },
         *                 "weight": 0.64
         *               },
         *               {
         *                 "clip": "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08",
         *                 "keytimes": {
         *                   "left_off": 0.68,
         *                   "left_strike": 0,
         *                   "right_off": 0.14,
         *                   "right_strike": 0.54
         *                 },
         *                 "weight": 0.36
         *               }
         *             ]
         *           }
         *         }
         *       ],
         *       "outside": 0,
         *       "source": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "weights": [
         *         0.64,
         *         0.36
         *       ]
         *     }
         */
        SpaceRecipe: {
            /** Weights */
            weights: number[];
            /** Outside */
            outside: number;
            /** Notes */
            notes: string[];
            /** Source */
            source: string;
            /** Operations */
            operations: {
                [key: string]: unknown;
            }[];
        };
        /**
         * Stability
         * @description Bootstrap over participants.
         *
         *     Attributes:
         *         clusters: as the tree is cut, moves by hand aside.
         *         whole: agreement with the solution of all participants, over all pairs that were asked;
         *             those left out are a group of their own.
         *         shared: the same over the pairs that both keep; None where no sample keeps enough.
         *         by_participants: the same for other numbers of participants.
         */
        Stability: {
            /** Samples */
            samples: number;
            /** Seed */
            seed: number;
            /** Participants */
            participants: number;
            /** Pairs */
            pairs: components["schemas"]["PairStability"][];
            /** Clusters */
            clusters: components["schemas"]["ClusterStability"][];
            whole: components["schemas"]["Agreement"];
            shared: components["schemas"]["Agreement"] | null;
            /** By Participants */
            by_participants: components["schemas"]["ByParticipants"][];
            enough: components["schemas"]["Enough"];
            /** Sentence */
            sentence: string;
        };
        /**
         * StateChange
         * @description Whether new participants may begin.
         */
        StateChange: {
            /**
             * State
             * @enum {string}
             */
            state: "open" | "paused" | "closed";
        };
        /**
         * Step
         * @description One operation of a recipe; what it takes is told by ``GET /api/v1/operations``.
         * @example {
         *       "operation": "grid@1",
         *       "parameters": {
         *         "path": 0.4,
         *         "timing": 1.6
         *       }
         *     }
         */
        Step: {
            /** Operation */
            operation: string;
            /**
             * Parameters
             * @default {}
             */
            parameters: {
                [key: string]: unknown;
            };
        };
        /**
         * StepView
         * @description One step of the way: a trial about figures, or a page.
         *
         *     Attributes:
         *         part: the part of the study that it belongs to.
         *         figures: those to be judged, as they stand on the page; in `abx` the third is X.
         *         reference: the figure to compare with, in red.
         *         instruction: what an attention check says to answer.
         *         scales: the ids of the scales in the order in which they stand; null: as in the part.
         *         interface, seen: of `match`, which sliders make the motion, and whether it is seen; a guess
         *             has no clock.
         */
        StepView: {
            /** Index */
            index: number;
            /** Part */
            part: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "semantic_differential" | "unipolar" | "likert" | "analogue" | "choose" | "ab" | "abx" | "parallel" | "ranking" | "free_text" | "match" | "form" | "instructions" | "break" | "comment" | "debriefing";
            /** Figures */
            figures: components["schemas"]["FigureView"][];
            reference?: components["schemas"]["FigureView"] | null;
            /** Instruction */
            instruction?: string | null;
            /** Scales */
            scales?: string[] | null;
            /** Interface */
            interface?: ("adjectives" | "features" | "weights") | null;
            /** Seen */
            seen?: boolean | null;
        };
        /**
         * StudyCounts
         * @description How many participants stand where; simulated ones and those left out are not among them.
         */
        StudyCounts: {
            /**
             * Complete
             * @default 0
             */
            complete: number;
            /**
             * Active
             * @default 0
             */
            active: number;
            /**
             * Withdrawn
             * @default 0
             */
            withdrawn: number;
        };
        /**
         * StudyDetail
         * @description A study with everything that its makers work on.
         *
         *     Attributes:
         *         draft: the study file as it is being edited; None where it equals the newest version.
         *         saved_at: when the draft was last saved or, if it never was, the study was made.
         *         definition: the newest version.
         *         problems: of the draft; none of them keeps it from being saved.
         *         can_be_shown: whether the preview can show it in spite of them.
         */
        StudyDetail: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /**
             * State
             * @enum {string}
             */
            state: "draft" | "open" | "paused" | "closed";
            /**
             * Role
             * @enum {string}
             */
            role: "owner" | "editor" | "viewer";
            /** Draft */
            draft: {
                [key: string]: unknown;
            } | null;
            /**
             * Saved At
             * Format: date-time
             */
            saved_at: string;
            /** Definition */
            definition: {
                [key: string]: unknown;
            } | null;
            /** Versions */
            versions: components["schemas"]["VersionLine"][];
            running: components["schemas"]["Running"];
            /** Problems */
            problems: components["schemas"]["Problem"][];
            /** Can Be Shown */
            can_be_shown: boolean;
        };
        /**
         * StudyDraft
         * @description What is being edited of a study: the draft, or the newest version where there is none.
         *
         *     Attributes:
         *         version: number of the newest version; None before the first was published.
         *         parts: those that ask about clips.
         */
        StudyDraft: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /**
             * State
             * @enum {string}
             */
            state: "draft" | "open" | "paused" | "closed";
            /** Version */
            version: number | null;
            /** Languages */
            languages: string[];
            /** Parts */
            parts: components["schemas"]["AskingPart"][];
        };
        /**
         * StudyLine
         * @description A study in the list.
         *
         *     Attributes:
         *         version: number of the newest version; None before the first was published.
         *         draft: whether there are changes that no version has yet.
         */
        StudyLine: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /**
             * State
             * @enum {string}
             */
            state: "draft" | "open" | "paused" | "closed";
            /**
             * Role
             * @enum {string}
             */
            role: "owner" | "editor" | "viewer";
            /** Version */
            version: number | null;
            /** Draft */
            draft: boolean;
            counts: components["schemas"]["StudyCounts"];
            /**
             * Created At
             * Format: date-time
             */
            created_at: string;
        };
        /**
         * StudyList
         * @description Every study that the caller may see.
         */
        StudyList: {
            /** Studies */
            studies: components["schemas"]["StudyLine"][];
        };
        /**
         * StudyResults
         * @description All of the results page's numbers, of one part.
         *
         *     Attributes:
         *         state: of the study: open, paused or closed.
         *         study_hash: of the newest version.
         *         needed: complete participants below which nothing is computed.
         *         participants: complete ones that saw the part, whose answers are analysed.
         *         rule: which answers are analysed, in words.
         *         kind: whose: people's, or simulated participants'; simulated: how many of those there are.
         *         against: "others" compares a best clip with the other clips of its body, "all" with all.
         *         parts: all parts that ask about clips; part: the one that the numbers are of.
         *         axes: what was answered by numbers; choices: by choosing; poles: of bipolar scales alone.
         *         matching: what came of matching targets; null for parts of other kinds, and while too few
         *             are complete.
         *         texts: how many answers in words there are; they are read in the exports.
         */
        StudyResults: {
            /** Slug */
            slug: string;
            /** Title */
            title: string;
            /** State */
            state: string;
            /** Study Hash */
            study_hash: string;
            /** Needed */
            needed: number;
            /** Participants */
            participants: number;
            /** Rule */
            rule: string;
            /**
             * Kind
             * @enum {string}
             */
            kind: "participant" | "simulated";
            /** Simulated */
            simulated: number;
            /**
             * Against
             * @enum {string}
             */
            against: "others" | "all";
            counts: components["schemas"]["Counts"];
            /** Parts */
            parts: components["schemas"]["PartName"][];
            part: components["schemas"]["PartName"];
            /** Clips */
            clips: components["schemas"]["Clip"][];
            /** Axes */
            axes: components["schemas"]["Axis"][];
            /** Choices */
            choices: components["schemas"]["Choices"][];
            /** Poles */
            poles: components["schemas"]["PoleRow"][];
            matching: components["schemas"]["Matching"] | null;
            /** Texts */
            texts: number;
        };
        /**
         * StudyView
         * @description What a participant's page shows of the study as a whole.
         */
        StudyView: {
            /** Title */
            title: string;
            /** Language */
            language: string;
            /** Languages */
            languages: components["schemas"]["LanguageView"][];
            /** Back */
            back: boolean;
            /**
             * Preview
             * @default false
             */
            preview: boolean;
        };
        /**
         * Suspicion
         * @description A rule that a session breaks: by what number, and what the rule is.
         */
        Suspicion: {
            /**
             * Id
             * @enum {string}
             */
            id: "same_answers" | "flat_answers" | "too_fast" | "failed_checks" | "hidden";
            /** Title */
            title: string;
            /** Number */
            number: string;
            /** Rule */
            rule: string;
        };
        /**
         * Target
         * @description A drawn target, and the point that it was drawn at.
         * @example {
         *       "name": "Target 1",
         *       "notes": [],
         *       "operations": [
         *         {
         *           "operation": "blend@1",
         *           "parameters": {
         *             "examples": [
         *               {
         *                 "clip": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *                 "keytimes": {
         *                   "left_off": 0.68,
         *                   "left_strike": 0,
         *                   "right_off": 0.14,
         *                   "right_strike": 0.54
         *                 },
         *                 "weight": 0.64
         *               },
         *               {
         *                 "clip": "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08",
         *                 "keytimes": {
         *                   "left_off": 0.68,
         *                   "left_strike": 0,
         *                   "right_off": 0.14,
         *                   "right_strike": 0.54
         *                 },
         *                 "weight": 0.36
         *               }
         *             ]
         *           }
         *         }
         *       ],
         *       "outside": 0,
         *       "source": "0f4c2b5f4a0c4b0fb5ac9d5bb5a3c5d7d9d9a9b75b9cbe9b8c1f6a4b6a0e9d11",
         *       "values": {
         *         "largeness": 0.6,
         *         "quickness": 0.8
         *       },
         *       "weights": [
         *         0.64,
         *         0.36
         *       ]
         *     }
         */
        Target: {
            /** Weights */
            weights: number[];
            /** Outside */
            outside: number;
            /** Notes */
            notes: string[];
            /** Source */
            source: string;
            /** Operations */
            operations: {
                [key: string]: unknown;
            }[];
            /** Name */
            name: string;
            /** Values */
            values: {
                [key: string]: number;
            };
        };
        /**
         * TargetList
         * @description Targets in the order in which they were drawn.
         */
        TargetList: {
            /** Targets */
            targets: components["schemas"]["Target"][];
        };
        /**
         * TargetRequest
         * @description Motions to be matched, drawn at random from a space's primary adjectives.
         *
         *     Attributes:
         *         count: how many; the drawn ones lie far from each other.
         *         seed: the same number, the same targets.
         * @example {
         *       "count": 5,
         *       "seed": 1
         *     }
         */
        TargetRequest: {
            /**
             * Count
             * @default 5
             */
            count: number;
            /**
             * Seed
             * @default 1
             */
            seed: number;
        };
        /**
         * TemplateLine
         * @description A study that is ready to be taken as a beginning.
         */
        TemplateLine: {
            /** Id */
            id: string;
            /** Title */
            title: string;
            /** Summary */
            summary: string;
            /** Minutes */
            minutes: number;
        };
        /**
         * TemplateList
         * @description The templates that come with the server.
         */
        TemplateList: {
            /** Templates */
            templates: components["schemas"]["TemplateLine"][];
        };
        /**
         * ToldAnswer
         * @description One value of an answer, in words.
         */
        ToldAnswer: {
            /** Label */
            label: string;
            /** Value */
            value: string;
        };
        /**
         * TransitionKey
         * @description What tells a transition from the others of its graph; frames are counted from 0.
         * @example {
         *       "source": "stand",
         *       "source_frame": 30,
         *       "target": "walk",
         *       "target_frame": 12
         *     }
         */
        TransitionKey: {
            /** Source */
            source: string;
            /** Source Frame */
            source_frame: number;
            /** Target */
            target: string;
            /** Target Frame */
            target_frame: number;
        };
        /**
         * TransitionView
         * @description A transition; distance in metres, turn in radians about the vertical.
         * @example {
         *       "added": false,
         *       "distance": 0.021,
         *       "source": "stand",
         *       "source_frame": 30,
         *       "target": "walk",
         *       "target_frame": 12,
         *       "turn": 0.4
         *     }
         */
        TransitionView: {
            /** Source */
            source: string;
            /** Source Frame */
            source_frame: number;
            /** Target */
            target: string;
            /** Target Frame */
            target_frame: number;
            /** Distance */
            distance: number;
            /** Turn */
            turn: number;
            /** Added */
            added: boolean;
        };
        /**
         * UploadedFile
         * @description A study file: its text, and its name, whose ending tells YAML from JSON.
         */
        UploadedFile: {
            /** Name */
            name: string;
            /** Text */
            text: string;
        };
        /**
         * VersionLine
         * @description A published version: never changed, and answers belong to it.
         *
         *     Attributes:
         *         hash: SHA-256 of its definition's canonical JSON.
         *         changes: what it changed against the version before, one sentence each.
         *         sessions: how many participants began it.
         */
        VersionLine: {
            /** Number */
            number: number;
            /** Hash */
            hash: string;
            /**
             * Published At
             * Format: date-time
             */
            published_at: string;
            /** Changes */
            changes: string[];
            /** Sessions */
            sessions: number;
        };
        /**
         * Viewed
         * @description How a trial was viewed, in words.
         */
        Viewed: {
            /** Label */
            label: string;
            /** Value */
            value: string;
        };
        /**
         * ViewingRecord
         * @description How the figures were watched. Times in ms; what a browser cannot tell is left out.
         *
         *     Attributes:
         *         figure_ms: of several figures, how long each was in view and moving.
         *         camera: how the view was turned, as [ms since the figures came, azimuth and elevation in
         *             degrees, zoom]; left out where it stayed as it was.
         *         start: sliders that showed a position before they were touched, and which.
         *         path: every move of a slider, as [ms since the figures came, slider, position 0 … 1].
         */
        ViewingRecord: {
            /** Plays */
            plays?: number | null;
            /** Viewing Ms */
            viewing_ms?: number | null;
            /** Camera Moves */
            camera_moves?: number | null;
            /** Hidden Ms */
            hidden_ms?: number | null;
            /** Blur Count */
            blur_count?: number | null;
            /** Dropped Frames */
            dropped_frames?: number | null;
            /** Tier */
            tier?: string | null;
            viewport?: components["schemas"]["Viewport"] | null;
            /** Figure Ms */
            figure_ms?: number[] | null;
            /** Camera */
            camera?: [
                number,
                number,
                number,
                number
            ][] | null;
            /** Start */
            start?: {
                [key: string]: number;
            } | null;
            /** Path */
            path?: [
                number,
                string,
                number
            ][] | null;
        };
        /**
         * Viewport
         * @description Size of the page in CSS pixels.
         */
        Viewport: {
            /** Width */
            width: number;
            /** Height */
            height: number;
            /** Pixel Ratio */
            pixel_ratio: number;
        };
        /**
         * Weighed
         * @description What a point means.
         *
         *     Attributes:
         *         weights: of each example, in the space's order; their sum is 1.
         *         outside: how far the point lies outside of what the examples span, in slider lengths; 0
         *             within.
         *         notes: what there is to know, in sentences.
         * @example {
         *       "notes": [],
         *       "outside": 0,
         *       "weights": [
         *         0.64,
         *         0.36
         *       ]
         *     }
         */
        Weighed: {
            /** Weights */
            weights: number[];
            /** Outside */
            outside: number;
            /** Notes */
            notes: string[];
        };
        /**
         * Words
         * @description A text: one for all languages, or one for each (`{en: …, fi: …, ja: …}`).
         */
        Words: string | {
            [key: string]: string;
        };
    };
    responses: never;
    parameters: never;
    requestBodies: never;
    headers: never;
    pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
    show_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                token: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SessionView"];
                };
            };
            /** @description The personal link is not known. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    record_response: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                token: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Answer"];
            };
        };
        responses: {
            /** @description The same answer was stored before. */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AnswerReceipt"];
                };
            };
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AnswerReceipt"];
                };
            };
            /** @description The personal link is not known. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description It contradicts what is stored. */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_motion: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                token: string;
                index: number;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Moved"];
            };
        };
        responses: {
            /** @description The motion, with its distance from the target in `Manner-Distance` */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": unknown;
                };
            };
            /** @description The personal link is not known. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description It contradicts what is stored. */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Asked more often than a hand moves a slider. */
            429: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    complete: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                token: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Completion"];
                };
            };
            /** @description The personal link is not known. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description It contradicts what is stored. */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_clips: {
        parameters: {
            query?: {
                /** @description Words of name or tags */
                query?: string;
                /** @description `emotion:sad`, or a value alone */
                tag?: string[];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    create_clip: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ClipRequest"];
            };
        };
        responses: {
            /** @description OK */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipDetail"];
                };
            };
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    clip_as_json: {
        parameters: {
            query?: {
                /** @description The motion as well */
                motion?: boolean;
            };
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The clip */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipDocument"];
                };
            };
            /** @description The part that was asked for */
            206: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description What the client has is what there is */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The file has no such part */
            416: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    clip_as_glb: {
        parameters: {
            query?: {
                /** @description The figure as well */
                figure?: boolean;
            };
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The clip */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": string;
                };
            };
            /** @description The part that was asked for */
            206: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description What the client has is what there is */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The file has no such part */
            416: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    clip_as_bvh: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The clip */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/x-bvh": string;
                };
            };
            /** @description The part that was asked for */
            206: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description What the client has is what there is */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The file has no such part */
            416: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_clip: {
        parameters: {
            query?: {
                /** @description The motion as well */
                motion?: boolean;
                /** @description The figure as well */
                figure?: boolean;
            };
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The clip */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": string;
                    "text/x-bvh": string;
                    "application/json": components["schemas"]["ClipDocument"];
                };
            };
            /** @description The part that was asked for */
            206: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description What the client has is what there is */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The file has no such part */
            416: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    delete_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    correct_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["ImportOptions"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Imported"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    confirm_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    label_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Label"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    preview_clip: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Edit"];
            };
        };
        responses: {
            /** @description The edited clip without a figure */
            200: {
                headers: {
                    /** @description Recipe's hash */
                    "X-Manner-Recipe"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": string;
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    check_clip: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Edit"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Checked"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    ease_off_clip: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Edit"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["EasedOff"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    clip_quality: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Checked"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    rebuild_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Rebuilt"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_skeletons: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SkeletonList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    clip_retargeting: {
        parameters: {
            query: {
                /** @description A clip that moves the other skeleton */
                onto: string;
                /** @description `cycle@1` goes first: on the stride it finds, or on the whole motion */
                cycle?: "none" | "found" | "whole";
            };
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Retargeting"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_operations: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["OperationList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_operation: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["OperationView"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_presets: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PresetList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_poses: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PoseList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    capture_pose: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PoseRequest"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["PoseView"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    delete_pose: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                pose_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_graphs: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GraphList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    create_graph: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["GraphRequest"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GraphDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    preview_graph: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["GraphShape"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GraphTransitions"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_graph: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                graph_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GraphDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    change_graph: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                graph_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["GraphRequest"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["GraphDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    delete_graph: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                graph_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    play_graph: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                graph_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["PlayRequest"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Piece"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    import_motion: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "multipart/form-data": components["schemas"]["Body_import_motion"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Imported"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    read_live: {
        parameters: {
            query?: {
                kind?: "participant" | "simulated";
                page?: number;
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["LiveView"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    read_audit: {
        parameters: {
            query?: {
                before?: number | null;
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AuditTrail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    read_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                session_id: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SessionDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    delete_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                session_id: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    export_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                session_id: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description All that is stored of one participant */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    exclude_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                session_id: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    include_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                session_id: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    flag_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                session_id: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Reason"];
            };
        };
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    unflag_session: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                session_id: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_members: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MemberList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    put_member: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                email: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["MemberRole"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["MemberList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    remove_member: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                email: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    read_results: {
        parameters: {
            query?: {
                against?: "others" | "all";
                part?: string | null;
                kind?: "participant" | "simulated";
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyResults"];
                };
            };
            /** @description An API key or signing in is needed. */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description There is no such study. */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    read_impressions: {
        parameters: {
            query?: {
                part?: string | null;
                kind?: "participant" | "simulated";
                least_peak?: number | null;
                most_spread?: number | null;
                clusters?: number | null;
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Impressions"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    draw_stability: {
        parameters: {
            query?: {
                kind?: "participant" | "simulated";
                samples?: number;
                seed?: number;
                least_peak?: number | null;
                most_spread?: number | null;
                clusters?: number | null;
            };
            header?: never;
            path: {
                part: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Stability"] | components["schemas"]["JobDetail"];
                };
            };
            /** @description Accepted */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    read_stability: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                part: string;
                job: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Stability"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    compare_impressions: {
        parameters: {
            query: {
                other: string;
                other_part?: string | null;
                kind?: "participant" | "simulated";
            };
            header?: never;
            path: {
                part: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Comparison"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_comparable: {
        parameters: {
            query?: {
                kind?: "participant" | "simulated";
            };
            header?: never;
            path: {
                part: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ComparableList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    freeze_impressions: {
        parameters: {
            query?: {
                kind?: "participant" | "simulated";
            };
            header?: never;
            path: {
                part: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Freeze"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpaceLine"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    choose_impressions: {
        parameters: {
            query?: {
                kind?: "participant" | "simulated";
                /** @description `saved_at` of the choices that these were made from */
                seen?: string | null;
            };
            header?: never;
            path: {
                part: string;
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["AnalysisChoices"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Impressions"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_studies: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    create_study: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewStudy"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_study: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    delete_study: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    save_draft: {
        parameters: {
            query?: {
                /** @description `saved_at` of the draft that this one was made from */
                seen?: string | null;
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": {
                    [key: string]: unknown;
                };
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SavedDraft"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    discard_draft: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    add_clips: {
        parameters: {
            query?: {
                /** @description `saved_at` of the draft that this one was made from */
                seen?: string | null;
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewClips"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ClipsAdded"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_changes: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Changes"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    publish_study: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Changes"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    change_running: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Running"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    change_state: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["StateChange"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    duplicate_study: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["StudyDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    make_invitations: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["InvitationRequest"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["InvitationList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    download_study_file: {
        parameters: {
            query?: {
                version?: number | null;
                format?: "yaml" | "json";
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The study file */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/yaml": string;
                    "application/json": Record<string, never>;
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    preview_study: {
        parameters: {
            query?: {
                language?: ("en" | "fi" | "ja") | null;
                part?: string | null;
            };
            header?: never;
            path: {
                slug: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SessionView"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    preview_motion: {
        parameters: {
            query?: {
                part?: string | null;
            };
            header?: never;
            path: {
                index: number;
                slug: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Moved"];
            };
        };
        responses: {
            /** @description The motion */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": unknown;
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_study_templates: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TemplateList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_study_drafts: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["DraftList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    create_batch: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Batch"];
            };
        };
        responses: {
            /** @description Successful Response */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    plan_batch: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Choice"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Plan"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    plan_foerger: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Plan"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_jobs: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_job: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                job_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    cancel_job: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                job_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["JobDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    list_spaces: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpaceList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    create_space: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewSpace"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpaceDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    show_space: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                space_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpaceDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    delete_space: {
        parameters: {
            query?: {
                /** @description The space alone, or all versions of its name: all or none */
                versions?: "one" | "all";
            };
            header?: never;
            path: {
                space_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    weigh_point: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                space_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Point"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Weighed"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    move_point: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                space_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Point"];
            };
        };
        responses: {
            /** @description The motion without a figure */
            200: {
                headers: {
                    /** @description Of each example, in the space's order */
                    "Manner-Weights"?: string;
                    /** @description How far outside of the examples, 0 within */
                    "Manner-Outside"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "model/gltf-binary": string;
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    write_recipe: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                space_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["Point"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpaceRecipe"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    create_space_version: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                space_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["NewVersion"];
            };
        };
        responses: {
            /** @description Successful Response */
            201: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SpaceDetail"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    predict_clip: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                space_id: string;
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Prediction"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    draw_targets: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                space_id: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": components["schemas"]["TargetRequest"];
            };
        };
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["TargetList"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
    clip_keytimes: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                clip_id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Successful Response */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["KeytimesView"];
                };
            };
            /** @description Needs an API key, or a signed-in researcher */
            401: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description The API key may only read, or the request lacks its token against forgery */
            403: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Not found */
            404: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Contradicts what is stored */
            409: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description More bytes than the server takes */
            413: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Does not make sense */
            422: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
            /** @description Too much to do at this moment */
            503: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ErrorResponse"];
                };
            };
        };
    };
}
